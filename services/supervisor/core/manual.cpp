#include "services/supervisor/core/manual.hpp"

#include <cstdio>

namespace scarab::supervisor {

std::string phrase(const Manual& manual) {
  if (manual.hold == Manual::Hold::kNothing) return "nothing";
  if (manual.hold == Manual::Hold::kMode) return "mode " + std::string(name(manual.mode));
  std::string text = "inputs";
  for (const double value : manual.inputs) {
    std::array<char, 32> figure{};
    std::snprintf(figure.data(), figure.size(), " %.3g", value);
    text += figure.data();
  }
  return text;
}

}  // namespace scarab::supervisor
