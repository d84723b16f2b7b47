#include "tests/interop/fastdds/kept_state.hpp"

#include <fstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace scarab::fastdds {

static_assert(std::is_trivially_copyable_v<KeptState>, "it is written as it is");

StateFile::StateFile(const std::filesystem::path& run_dir, std::uint32_t instance) {
  if (run_dir.empty()) return;
  std::filesystem::create_directories(run_dir / "state");
  path_ = run_dir / "state" / ("fastdds-premotor-" + std::to_string(instance) + ".state");
}

std::optional<KeptState> StateFile::read() const {
  KeptState state;
  std::ifstream file(path_, std::ios::binary);
  if (!file.read(reinterpret_cast<char*>(&state), sizeof(state))) return std::nullopt;
  return state;
}

void StateFile::write(const KeptState& state) const {
  if (path_.empty()) return;
  const std::filesystem::path fresh = path_.string() + ".new";
  std::ofstream file(fresh, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&state), sizeof(state));
  file.close();
  if (!file) throw std::runtime_error(fresh.string() + ": cannot be written");
  std::filesystem::rename(fresh, path_);
}

}  // namespace scarab::fastdds
