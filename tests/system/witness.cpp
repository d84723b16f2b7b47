#include "tests/system/witness.hpp"

#include "common/bus/cdr.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

bus::ReaderOptions keep_all() {
  bus::ReaderOptions options;
  options.keep_all = true;
  return options;
}

/// The topic, read so that what is sent during the handshake is not lost.
template <class T>
bus::Topic<T> from_the_first(bus::Topic<T> topic) {
  topic.profile = bus::Profile::kState;
  return topic;
}

}  // namespace

Witness::Witness()
    : participant_(test_options("logger", 1)),
      status_(participant_, participant_.self()),
      trials_(participant_, bus::kTrial),
      states_(participant_, bus::kRobotState, keep_all()),
      sensors_(participant_, from_the_first(bus::kRobotSensors), keep_all()),
      behaviours_(participant_, bus::kBehaviour, keep_all()),
      commands_(participant_, bus::kJointCommand, keep_all()),
      activities_(participant_, bus::kNeuralActivity, keep_all()),
      worlds_(participant_, from_the_first(bus::kWorldState), keep_all()) {
  status_.set_lifecycle(scarab_LIFECYCLE_ACTIVE);
  status_.publish_if_due();
}

bool Witness::matched() const {
  return !states_.matched().empty() && !sensors_.matched().empty() &&
         !behaviours_.matched().empty() && !commands_.matched().empty() &&
         !activities_.matched().empty() && !worlds_.matched().empty();
}

/// A match counts once its handshake is over; as in the logger, nothing tells when that is.
bool Witness::settled() {
  constexpr std::chrono::milliseconds kHandshake{50};
  const auto now = std::chrono::steady_clock::now();
  if (!matched()) matched_since_.reset();
  if (matched() && !matched_since_) matched_since_ = now;
  return matched_since_ && now - *matched_since_ > kHandshake;
}

template <class T>
void Witness::take(bus::Reader<T>& reader) {
  reader.take([&](const T& sample) { seen_.add(reader.topic(), bus::encode(sample)); });
}

const Trajectory& Witness::look() {
  trials_.take([this](const scarab_Trial& trial) { trial_ = trial.header.trial; });
  if (trial_ != 0 && settled()) status_.set_ready(trial_);
  status_.publish_if_due();
  take(states_);
  take(sensors_);
  take(behaviours_);
  take(commands_);
  take(activities_);
  take(worlds_);
  return seen_;
}

std::int64_t Witness::tick() {
  const auto& states = look().of(states_.topic());
  return states.empty() ? -1 : std::int64_t{states.rbegin()->first.first};
}

}  // namespace scarab::test
