#include "services/premotor/service.hpp"

#include <algorithm>

#include "common/bus/clock.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/chain_responder.hpp"
#include "common/runtime/tick_masters.hpp"
#include "services/premotor/adapter.hpp"

namespace scarab::premotor {
namespace {

class PremotorLink {
 public:
  using Question = scarab_Behaviour;
  using State = NetworkState;
  static constexpr std::uint32_t kStateLayout = 1;

  PremotorLink(bus::Participant& participant, const bus::Peer& self, const PremotorConfig& config,
               const robot::RobotModel& robot)
      : self_(self),
        controller_(config, robot),
        commands_(participant, bus::kJointCommand),
        activities_(participant, bus::kNeuralActivity),
        replicas_(participant, bus::kNeuralActivity) {}

  void begin(const scarab_Trial& trial, NetworkState& state) {
    state = controller_.initial_state(trial.seed, trial.perturb_cpg_phase);
  }

  void advance(NetworkState& state, const scarab_Behaviour& behaviour) {
    state = controller_.step(state, to_intent(behaviour));
  }

  void answer(const NetworkState& state, const scarab_Behaviour& behaviour) {
    const MotorIntent intent = to_intent(behaviour);
    scarab_Header header = behaviour.header;
    header.stamp_ns = bus::now_ns();
    // The state goes out first: whoever has the command can find the state that made it, and where
    // this process is killed between the two, no log lacks it.
    scarab_NeuralActivity activity{};
    activity.header = header;
    fill(activity, state);
    activities_.write(activity);
    scarab_JointCommand command{};
    command.header = header;
    fill(command, controller_.targets(state, intent), intent.stop);
    commands_.write(command);
  }

  bool ends(const scarab_Behaviour& behaviour) const {
    return behaviour.state == scarab_BEHAVIOUR_DONE || behaviour.state == scarab_BEHAVIOUR_FAILED;
  }

  std::optional<runtime::RecordKey> adopt(std::uint32_t trial, NetworkState& state) {
    std::optional<runtime::RecordKey> key;
    replicas_.take([&](const scarab_NeuralActivity& activity) {
      if (activity.header.trial != trial) return;
      state = to_network_state(activity);
      key = {trial, static_cast<std::int64_t>(activity.header.tick)};
    });
    return key;
  }

  bool has_replica() const {
    const auto peers = replicas_.matched();
    return std::any_of(peers.begin(), peers.end(), [this](const bus::Peer& peer) {
      return peer.service == self_.service && peer.instance != self_.instance;
    });
  }

  void report(runtime::StatusPublisher&) const {}

  void add_needs(runtime::PeerCheck& peers) {
    runtime::need_tick_master(peers, commands_);
    peers.need(commands_, "logger");
    peers.need(activities_, "logger");
  }

 private:
  bus::Peer self_;
  PremotorController controller_;
  bus::Writer<scarab_JointCommand> commands_;
  bus::Writer<scarab_NeuralActivity> activities_;
  bus::Reader<scarab_NeuralActivity> replicas_;
};

}  // namespace

void serve(const runtime::ServiceOptions& options, const PremotorConfig& config,
           const robot::RobotModel& robot) {
  const bus::Peer self{"premotor", options.instance};
  bus::Participant participant(options.bus.participant(self.service, self.instance));
  runtime::PeerCheck peers(options.expect);
  PremotorLink link(participant, self, config, robot);
  runtime::ChainResponder<PremotorLink> responder(participant, options, self, bus::kBehaviour, link,
                                                  peers);
  link.add_needs(peers);
  peers.need(responder.questions(), "supervisor");
  responder.run();
}

}  // namespace scarab::premotor
