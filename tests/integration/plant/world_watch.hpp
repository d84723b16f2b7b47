#pragma once

#include <optional>
#include <string>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "tests/support/eventually.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {

/// The referee's verdict, as scarab/world_state tells it.
class WorldWatch {
 public:
  struct Verdict {
    scarab_Verdict verdict;
    std::string reason;
    scarab_Header header;
  };

  /// The verdict of a trial, waited for.
  std::optional<Verdict> await(std::uint32_t trial, std::chrono::milliseconds limit = kPatience) {
    std::optional<Verdict> found;
    eventually(
        [&] {
          worlds_.take([&](const scarab_WorldState& world) {
            if (world.header.trial != trial || world.verdict == scarab_VERDICT_OPEN) return;
            found = {world.verdict, world.verdict_reason, world.header};
          });
          return found.has_value();
        },
        limit);
    return found;
  }
  [[nodiscard]] bool matched() const { return !worlds_.matched().empty(); }

 private:
  bus::Participant participant_{test_options("view")};
  bus::Reader<scarab_WorldState> worlds_{participant_, bus::kWorldState};
};

}  // namespace scarab::test
