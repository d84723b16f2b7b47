#include "tests/interop/fastdds/echo.hpp"

#include "tests/interop/fastdds/sample_json.hpp"

namespace scarab::fastdds {
namespace {

constexpr std::chrono::milliseconds kPoll{20};  // for signals; samples wake it at once
constexpr bool kKeepAll = true;

}  // namespace

Echo::Echo(Node& node, const Expectation& expect, std::ostream& out)
    : node_(node),
      expect_(expect),
      out_(out),
      states_(node, kRobotState, kKeepAll),
      sensors_(node, kRobotSensors, kKeepAll),
      behaviours_(node, kBehaviour, kKeepAll),
      commands_(node, kJointCommand, kKeepAll),
      activities_(node, kNeuralActivity, kKeepAll),
      worlds_(node, kWorldState, kKeepAll),
      trials_(node, kTrial, kKeepAll),
      statuses_(node, kServiceStatus, kKeepAll),
      operators_(node, kOperator, kKeepAll),
      status_(node) {
  status_.set_lifecycle(LIFECYCLE_INACTIVE);
}

void Echo::run(StopSignal& stop) {
  while (!stop.requested()) {
    take_all();
    if (trial_ != 0 && hears_everybody()) {
      status_.set_lifecycle(LIFECYCLE_ACTIVE);
      status_.set_ready(trial_);
    }
    status_.publish_if_due();
    node_.wait(kPoll);
  }
  status_.set_lifecycle(LIFECYCLE_FINALISED);
  status_.publish_if_due();
  take_all();
  out_.flush();
}

/// The newest robot_state last: what it is the answer to has been taken by then.
void Echo::take_all() {
  take(trials_, kTrial);
  take(operators_, kOperator);
  take(statuses_, kServiceStatus);
  take(worlds_, kWorldState);
  take(sensors_, kRobotSensors);
  take(behaviours_, kBehaviour);
  take(commands_, kJointCommand);
  take(activities_, kNeuralActivity);
  take(states_, kRobotState);
}

template <class Support>
void Echo::take(Reader<Support>& reader, const Topic<Support>& topic) {
  reader.take([&](const typename Support::type& sample) {
    out_ << R"({"topic":)" << quoted_text(topic.name) << R"(,"value":)" << json_text(sample)
         << "}\n";
    if constexpr (std::is_same_v<Support, TrialPubSubType>) trial_ = sample.header().trial();
    if constexpr (std::is_same_v<Support, RobotStatePubSubType>) {
      if (&reader == &states_) follow(sample);
    }
  });
}

/// Lockstep goes on when the loggers have recorded what came before.
void Echo::follow(const RobotState& state) {
  if (state.header().trial() == trial_) {
    status_.set_recorded(trial_, state.header().tick());
  }
}

bool Echo::hears_everybody() const {
  const auto heard = [this](const std::string& service, const std::vector<Peer>& peers) {
    return missing(expect_, service, peers, "").empty();
  };
  std::vector<Peer> reporting = statuses_.matched();
  reporting.push_back(node_.self());
  for (const auto& [service, count] : expect_) {
    if (!heard(service, reporting)) return false;
  }
  return heard("plant", states_.matched()) && heard("plant", sensors_.matched()) &&
         heard("plant", worlds_.matched()) && heard("supervisor", behaviours_.matched()) &&
         heard("premotor", commands_.matched()) && heard("premotor", activities_.matched());
}

}  // namespace scarab::fastdds
