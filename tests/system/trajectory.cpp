#include "tests/system/trajectory.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"

namespace scarab::test {
namespace {

// Behind the encapsulation: trial, tick, sim_time_ns, stamp_ns.
constexpr std::size_t kTickAt = 8;
constexpr std::size_t kTimeAt = 12;
constexpr std::size_t kStampAt = 20;
constexpr std::size_t kHeaderEnd = 28;

template <class T>
T number_at(sample::ByteView cdr, std::size_t offset) {
  T number;
  std::memcpy(&number, cdr.data + offset, sizeof(number));
  return number;
}

/// Where the flag real_time stands: in robot_state behind the phase, in behaviour first.
std::optional<std::size_t> real_time_at(const std::string& topic) {
  if (topic == bus::kRobotState.name || topic == bus::kRobotSensors.name) return kHeaderEnd + 4;
  if (topic == bus::kBehaviour.name) return kHeaderEnd;
  return std::nullopt;
}

std::string name_of(const std::string& topic, const Trajectory::Key& key) {
  return topic + ", tick " + std::to_string(key.first) + ", " + std::to_string(key.second) + " ns";
}

}  // namespace

const std::vector<std::string>& Trajectory::topics() {
  static const std::vector<std::string> names = {bus::kRobotState.name,     bus::kRobotSensors.name,
                                                 bus::kBehaviour.name,      bus::kJointCommand.name,
                                                 bus::kNeuralActivity.name, bus::kWorldState.name};
  return names;
}

Trajectory Trajectory::read(const std::filesystem::path& log) {
  Trajectory trajectory;
  mcap::Reader(log).for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        trajectory.add(channel.topic, {reinterpret_cast<const std::byte*>(message.data.data()),
                                       message.data.size()});
      },
      {topics().begin(), topics().end()});
  return trajectory;
}

void Trajectory::add(const std::string& topic, sample::ByteView cdr) {
  if (cdr.size < kHeaderEnd) throw std::runtime_error(topic + ": a sample without a header");
  const Key key{number_at<std::uint32_t>(cdr, kTickAt), number_at<std::int64_t>(cdr, kTimeAt)};
  sample::Bytes bytes(cdr.data, cdr.data + cdr.size);
  std::fill(bytes.begin() + kStampAt, bytes.begin() + kHeaderEnd, std::byte{0});
  const auto [entry, fresh] = samples_[topic].try_emplace(key, bytes);
  if (!fresh && entry->second != bytes) changed_.push_back(name_of(topic, key));
}

Trajectory Trajectory::paceless() const {
  Trajectory copy = *this;
  for (auto& [topic, samples] : copy.samples_) {
    const auto flag = real_time_at(topic);
    for (auto& [key, bytes] : samples) {
      if (flag) bytes.at(*flag) = std::byte{0};
    }
  }
  return copy;
}

const Trajectory::Samples& Trajectory::of(const std::string& topic) const {
  static const Samples none;
  const auto entry = samples_.find(topic);
  return entry == samples_.end() ? none : entry->second;
}

std::vector<std::string> Trajectory::contradictions(const Trajectory& whole) const {
  std::vector<std::string> found;
  for (const auto& name : changed_) found.push_back(name + ": came twice, and differently");
  for (const auto& [topic, samples] : samples_) {
    for (const auto& [key, bytes] : samples) {
      const auto wanted = whole.of(topic).find(key);
      if (wanted == whole.of(topic).end()) {
        found.push_back(name_of(topic, key) + ": should not be");
      } else if (wanted->second != bytes) {
        found.push_back(name_of(topic, key) + ": is other");
      }
    }
  }
  return found;
}

std::vector<Trajectory::Gap> Trajectory::gaps(const Trajectory& whole) const {
  std::vector<Gap> found;
  for (const auto& [topic, samples] : whole.samples_) {
    for (const auto& [key, bytes] : samples) {
      if (of(topic).count(key) == 0) found.push_back({topic, key.first});
    }
  }
  return found;
}

}  // namespace scarab::test
