#pragma once

#include <chrono>
#include <deque>

#include "services/premotor/core/premotor_controller.hpp"
#include "tests/interop/fastdds/kept_state.hpp"
#include "tests/interop/fastdds/reader.hpp"
#include "tests/interop/fastdds/status.hpp"
#include "tests/interop/fastdds/stop_signal.hpp"

namespace scarab::fastdds {

/// The premotor controller of the stack on Fast DDS: behaviour k in, neural_activity k and
/// joint_command k out (docs/replacing-a-node.md).
class Premotor {
 public:
  Premotor(Node& node, const Expectation& expect, const premotor::PremotorController& controller,
           const StateFile& file);

  /// Serves until it is told to stop.
  void run(StopSignal& stop);

 private:
  void begin(const Trial& trial);
  void check_peers();
  [[nodiscard]] std::string missing_peers() const;
  void answer_held();
  void answer(const Behaviour& question);
  void publish(const Behaviour& question);

  Node& node_;
  Expectation expect_;
  premotor::PremotorController controller_;
  StateFile file_;
  Reader<TrialPubSubType> trials_;
  Reader<BehaviourPubSubType> questions_;
  Writer<NeuralActivityPubSubType> activities_;
  Writer<JointCommandPubSubType> commands_;
  Status status_;

  KeptState state_;  ///< of the running trial; trial 0 before the first
  bool ready_ = false;
  std::chrono::steady_clock::time_point waiting_since_{};
  std::deque<Behaviour> held_;
};

}  // namespace scarab::fastdds
