#include "tests/system/witness.hpp"

#include <algorithm>

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
  take(states_);
  take(sensors_);
  take(behaviours_);
  take(commands_);
  take(activities_);
  take(worlds_);
  report();
  return seen_;
}

void Witness::report() {
  if (trial_ != 0 && settled()) status_.set_ready(trial_);
  std::int64_t seen = newest(states_.topic());
  for (const auto& topic : Trajectory::topics()) seen = std::min(seen, newest(topic));
  if (seen >= 0) status_.set_recorded(trial_, static_cast<std::uint32_t>(seen));
  status_.publish_if_due();
}

std::int64_t Witness::newest(const std::string& topic) const {
  const auto& samples = seen_.of(topic);
  return samples.empty() ? -1 : std::int64_t{samples.rbegin()->first.first};
}

std::int64_t Witness::tick() {
  look();
  return newest(states_.topic());
}

bool Witness::caught_up() {
  const std::int64_t answered = tick() - 1;
  return newest(behaviours_.topic()) >= answered && newest(commands_.topic()) >= answered &&
         newest(activities_.topic()) >= answered;
}

}  // namespace scarab::test
