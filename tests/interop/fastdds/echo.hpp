#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>

#include "tests/interop/fastdds/reader.hpp"
#include "tests/interop/fastdds/status.hpp"
#include "tests/interop/fastdds/stop_signal.hpp"

namespace scarab::fastdds {

/// Prints every sample of every topic, a line of JSON each. To the stack it is a logger: nobody
/// starts before it hears everybody, and lockstep waits for what it has seen.
class Echo {
 public:
  Echo(Node& node, const Expectation& expect, std::ostream& out);

  /// Until it is told to stop.
  void run(StopSignal& stop);

 private:
  void take_all();
  template <class Support>
  void take(Reader<Support>& reader, const Topic<Support>& topic);
  void follow(const RobotState& state);
  [[nodiscard]] bool hears_everybody() const;

  Node& node_;
  Expectation expect_;
  std::ostream& out_;
  Reader<RobotStatePubSubType> states_;
  Reader<RobotStatePubSubType> sensors_;
  Reader<BehaviourPubSubType> behaviours_;
  Reader<JointCommandPubSubType> commands_;
  Reader<NeuralActivityPubSubType> activities_;
  Reader<WorldStatePubSubType> worlds_;
  Reader<TrialPubSubType> trials_;
  Reader<ServiceStatusPubSubType> statuses_;
  Reader<OperatorPubSubType> operators_;
  Status status_;
  std::uint32_t trial_ = 0;
};

}  // namespace scarab::fastdds
