#include "tests/system/robot_bridge/wire_journal.hpp"

#include <algorithm>
#include <sstream>

#include "tests/support/files.hpp"

namespace scarab::test {

WireJournal::WireJournal(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::istringstream lines(text.substr(0, text.rfind('\n') + 1));
  std::string line;
  std::getline(lines, line);  // the header
  while (std::getline(lines, line)) {
    const auto first = line.find(',');
    const auto second = line.find(',', first + 1);
    if (second == std::string::npos) continue;
    events_.push_back({std::stoll(line.substr(0, first)),
                       line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
}

std::optional<WireJournal::Event> WireJournal::last(const std::string& name) const {
  const auto found = std::find_if(events_.rbegin(), events_.rend(),
                                  [&](const Event& event) { return event.name == name; });
  return found == events_.rend() ? std::nullopt : std::optional<Event>(*found);
}

std::optional<WireJournal::Event> WireJournal::first_after(const std::string& name,
                                                           std::int64_t stamp_ns) const {
  const auto found = std::find_if(events_.begin(), events_.end(), [&](const Event& event) {
    return event.name == name && event.stamp_ns >= stamp_ns;
  });
  return found == events_.end() ? std::nullopt : std::optional<Event>(*found);
}

std::size_t WireJournal::count(const std::string& name) const {
  return static_cast<std::size_t>(std::count_if(
      events_.begin(), events_.end(), [&](const Event& event) { return event.name == name; }));
}

}  // namespace scarab::test
