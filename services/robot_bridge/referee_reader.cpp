#include "services/robot_bridge/referee_reader.hpp"

namespace scarab::bridge {

RefereeReader::RefereeReader(bus::Participant& participant)
    : worlds_(participant, bus::kWorldState) {}

void RefereeReader::begin(std::uint32_t trial) {
  trial_ = trial;
  verdict_.reset();
}

const std::optional<runtime::TrialEnd>& RefereeReader::verdict() {
  worlds_.take([this](const scarab_WorldState& world) {
    const bool open = world.verdict == scarab_VERDICT_OPEN;
    if (open || verdict_ || world.header.trial != trial_) return;
    verdict_ = {world.verdict == scarab_VERDICT_SUCCESS, world.verdict_reason};
  });
  return verdict_;
}

}  // namespace scarab::bridge
