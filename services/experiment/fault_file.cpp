#include "services/experiment/fault_file.hpp"

#include <fstream>

namespace scarab::experiment {

std::optional<std::string> FaultFile::reason() const {
  if (path_.empty()) return std::nullopt;
  std::ifstream file(path_);
  std::string line;
  if (!std::getline(file, line)) return std::nullopt;
  return line;
}

}  // namespace scarab::experiment
