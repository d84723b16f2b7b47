#include "common/runtime/text_file.hpp"

#include <fstream>
#include <stdexcept>

namespace scarab::runtime {

void write_text(const std::filesystem::path& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text << std::flush;
  if (!file) throw std::runtime_error(path.string() + ": cannot write");
}

}  // namespace scarab::runtime
