#include "tools/emulator/journal.hpp"

#include <stdexcept>

namespace scarab::emulator {

Journal::Journal(const std::filesystem::path& path) {
  if (path.empty()) return;
  file_.open(path, std::ios::trunc);
  if (!file_) throw std::runtime_error("cannot write " + path.string());
  file_ << "stamp_ns,event,detail\n";
  file_.flush();
}

void Journal::note(std::int64_t stamp_ns, std::string_view event, std::string_view detail) {
  if (file_.is_open()) file_ << stamp_ns << ',' << event << ',' << detail << '\n';
}

void Journal::flush() {
  if (file_.is_open()) file_.flush();
}

}  // namespace scarab::emulator
