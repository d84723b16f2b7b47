#include "tools/emulator/bus_side.hpp"

#include "common/bus/clock.hpp"
#include "services/plant/adapter.hpp"

namespace scarab::emulator {

BusSide::BusSide(const bus::ParticipantOptions& options)
    : participant_(options),
      trials_(participant_, bus::kTrial),
      worlds_(participant_, bus::kWorldState) {}

std::optional<scarab_Trial> BusSide::take_trial() {
  std::optional<scarab_Trial> newest;
  trials_.take([&](const scarab_Trial& trial) {
    if (trial.header.trial != trial_) newest = trial;
  });
  if (newest) trial_ = newest->header.trial;
  return newest;
}

void BusSide::publish(std::uint32_t trial, std::uint32_t tick, std::int64_t time_ns,
                      const plant::WorldTruth& truth) {
  scarab_WorldState world{};
  world.header = {trial, tick, time_ns, bus::now_ns()};
  plant::fill(world, truth, contacts_);
  worlds_.write(world);
}

}  // namespace scarab::emulator
