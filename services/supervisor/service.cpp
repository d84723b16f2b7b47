#include "services/supervisor/service.hpp"

#include "common/bus/clock.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/chain_responder.hpp"
#include "services/supervisor/adapter.hpp"
#include "services/supervisor/core/machine_state.hpp"

namespace scarab::supervisor {
namespace {

/// What a restarted supervisor needs: the machine's memory, and its last decision to say it again.
struct KeptState {
  MachineState machine;
  Decision decision;
};

class SupervisorLink {
 public:
  using Question = scarab_RobotState;
  using State = KeptState;
  static constexpr std::uint32_t kStateLayout = 1;

  SupervisorLink(bus::Participant& participant, const SupervisorConfig& config)
      : config_(config), behaviours_(participant, bus::kBehaviour) {}

  void begin(const scarab_Trial& trial, KeptState& state) {
    machine_.emplace(config_, find_strategy(config_, trial.strategy));
    state = {machine_->initial_state(), Decision{}};
  }

  void advance(KeptState& state, const scarab_RobotState& question) {
    state.decision = machine_->step(state.machine, to_perception(question));
  }

  void answer(const KeptState& state, const scarab_RobotState& question) {
    scarab_Behaviour behaviour{};
    behaviour.header = question.header;
    behaviour.header.stamp_ns = bus::now_ns();
    behaviour.real_time = question.real_time;
    fill(behaviour, state.decision);
    behaviours_.write(behaviour);
  }

  bool ends(const scarab_RobotState& question) const {
    return question.phase == scarab_PHASE_SUCCEEDED || question.phase == scarab_PHASE_FAILED;
  }

  /// The machine's memory is on no topic: there is nothing to take over from a replica.
  std::optional<runtime::RecordKey> adopt(std::uint32_t, KeptState&) { return std::nullopt; }

  void add_needs(runtime::PeerCheck& peers) {
    peers.need(behaviours_, "premotor");
    peers.need(behaviours_, "plant");
    peers.need(behaviours_, "logger");
  }

 private:
  SupervisorConfig config_;
  std::optional<BehaviourMachine> machine_;
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
  peers.need(responder.questions(), "plant");
  responder.run();
}

}  // namespace scarab::supervisor
