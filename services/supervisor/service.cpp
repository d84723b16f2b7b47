#include "services/supervisor/service.hpp"

#include <string>

#include "common/bus/clock.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/chain_responder.hpp"
#include "common/runtime/tick_masters.hpp"
#include "services/supervisor/adapter.hpp"
#include "services/supervisor/core/machine_state.hpp"
#include "services/supervisor/operator_line.hpp"

namespace scarab::supervisor {
namespace {

/// What a restarted supervisor needs: the machine's memory, its last decision to say it again, and
/// the stamp of the last operator's word it has heard.
struct KeptState {
  MachineState machine;
  Decision decision;
  std::int64_t operator_stamp_ns = 0;
};

class SupervisorLink {
 public:
  using Question = scarab_RobotState;
  using State = KeptState;
  static constexpr std::uint32_t kStateLayout = 3;

  SupervisorLink(bus::Participant& participant, const SupervisorConfig& config)
      : config_(config), operator_(participant), behaviours_(participant, bus::kBehaviour) {}

  void begin(const scarab_Trial& trial, KeptState& state) {
    machine_.emplace(config_, find_strategy(config_, trial.strategy));
    state = {machine_->initial_state(), Decision{}};
    operator_.begin(trial.header.trial);
    complaint_.clear();
  }

  void advance(KeptState& state, const scarab_RobotState& question) {
    operator_.tell(*machine_, state.machine, question.header.tick, state.operator_stamp_ns);
    state.decision = machine_->step(state.machine, to_perception(question));
  }

  void answer(const KeptState& state, const scarab_RobotState& question) {
    scarab_Behaviour behaviour{};
    behaviour.header = question.header;
    behaviour.header.stamp_ns = bus::now_ns();
    behaviour.real_time = question.real_time;
    fill(behaviour, state.decision);
    behaviours_.write(behaviour);
    operator_.acknowledge(state.machine, state.operator_stamp_ns);
    complaint_ = machine_->complaint(state.machine);
    if (ends(question)) operator_.end();
  }

  void report(runtime::StatusPublisher& status) {
    operator_.report(status);
    if (!complaint_.empty() && status.health() == scarab_HEALTH_OK) {
      status.set_health(scarab_HEALTH_DEGRADED, complaint_);
    }
  }

  bool ends(const scarab_RobotState& question) const {
    return question.phase == scarab_PHASE_SUCCEEDED || question.phase == scarab_PHASE_FAILED;
  }

  /// The machine's memory is on no topic: a replica's can only be had from its file.
  std::optional<runtime::RecordKey> adopt(std::uint32_t, KeptState&) { return std::nullopt; }

  bool has_replica() const { return false; }

  void add_needs(runtime::PeerCheck& peers) {
    peers.need(behaviours_, "premotor");
    runtime::need_tick_master(peers, behaviours_);
    peers.need(behaviours_, "logger");
  }

 private:
  SupervisorConfig config_;
  std::optional<BehaviourMachine> machine_;
  OperatorLine operator_;
  std::string complaint_;  // what keeps the strategy from its end; empty: nothing
  bus::Writer<scarab_Behaviour> behaviours_;
};

}  // namespace

void serve(const runtime::ServiceOptions& options, const SupervisorConfig& config) {
  const bus::Peer self{"supervisor", options.instance};
  bus::Participant participant(options.bus.participant(self.service, self.instance));
  runtime::PeerCheck peers(options.expect);
  SupervisorLink link(participant, config);
  runtime::ChainResponder<SupervisorLink> responder(participant, options, self, bus::kRobotState,
                                                    link, peers);
  link.add_needs(peers);
  runtime::need_tick_master(peers, responder.questions());
  responder.run();
}

}  // namespace scarab::supervisor
