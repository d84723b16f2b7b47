#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scarab::test {

/// What the emulator has noted of its end of the wire, so far.
class WireJournal {
 public:
  struct Event {
    std::int64_t stamp_ns = 0;  ///< wall clock
    std::string name;           ///< such as goal, torque_off
    std::string detail;
  };

  /// Lines that are not whole yet are left out.
  explicit WireJournal(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<Event>& events() const { return events_; }
  /// The newest of that name; none if there is none.
  [[nodiscard]] std::optional<Event> last(const std::string& name) const;
  /// The first of that name at or after a moment.
  [[nodiscard]] std::optional<Event> first_after(const std::string& name,
                                                 std::int64_t stamp_ns) const;
  [[nodiscard]] std::size_t count(const std::string& name) const;

 private:
  std::vector<Event> events_;
};

}  // namespace scarab::test
