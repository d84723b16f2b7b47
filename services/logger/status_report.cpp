#include "services/logger/status_report.hpp"

#include "common/runtime/peers.hpp"

namespace scarab::logger {

StatusReport::StatusReport(bus::Participant& participant, const bus::Peer& self)
    : status_(participant, self) {
  status_.set_lifecycle(scarab_LIFECYCLE_INACTIVE);
  status_.publish_if_due();
}

void StatusReport::recorded(const RecordingState& state, const Loss& loss) {
  status_.set_recorded(state.progress.trial(), state.progress.tick());
  status_.set_counter("messages", state.messages);
  status_.set_counter("bytes", state.bytes);
  status_.set_counter("channels", state.channels);
  status_.set_counter("files", state.files);
  status_.set_counter("missed_ticks", state.progress.missed_ticks());
  status_.set_counter("dropped", loss.dropped);
  status_.set_counter("lost", loss.lost);
}

void StatusReport::ready(std::uint32_t trial) {
  ready_trial_ = trial;
  status_.set_ready(trial);
  status_.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
  status_.set_health(scarab_HEALTH_OK);
}

void StatusReport::waits_for(const std::vector<std::string>& missing) {
  status_.set_health(scarab_HEALTH_WAITING, "waits for " + runtime::join(missing));
}

void StatusReport::held_up(const std::string& obstacle) {
  status_.set_health(scarab_HEALTH_FAULT, obstacle);
}

void StatusReport::works(const RecordingState& state, const LossAccount& losses,
                         std::vector<std::string> faults) {
  if (losses.total().dropped > 0) faults.insert(faults.begin(), losses.dropped_in_words());
  if (state.progress.missed_ticks() > 0) {
    faults.push_back(std::to_string(state.progress.missed_ticks()) +
                     " ticks of robot_state missed");
  }
  status_.set_counter("faults", faults.size());
  if (faults.empty()) {
    status_.set_health(scarab_HEALTH_OK);
  } else {
    status_.set_health(scarab_HEALTH_DEGRADED, runtime::join(faults));
  }
}

void StatusReport::farewell(const std::string& obstacle) {
  status_.set_lifecycle(scarab_LIFECYCLE_FINALISED);
  if (!obstacle.empty()) status_.set_health(scarab_HEALTH_FAULT, obstacle);
  status_.publish_if_due();
}

}  // namespace scarab::logger
