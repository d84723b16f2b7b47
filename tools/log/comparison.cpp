#include "tools/log/comparison.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>

#include "common/bus/error.hpp"
#include "common/bus/sample_columns.hpp"
#include "tools/log/topic_type.hpp"
#include "tools/log/trial_samples.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;

std::string place(const ChainSample& sample) {
  std::ostringstream text;
  text << "trial " << sample.header.trial << ", tick " << sample.header.tick << " ("
       << static_cast<double>(sample.header.sim_time_ns) / kNsPerS << " s)";
  return text.str();
}

std::vector<std::string> values(const bus::TypeModel& type, const ChainSample& sample,
                                const bus::ColumnOptions& columns) {
  const auto* bytes = reinterpret_cast<const std::byte*>(sample.cdr.data());
  return bus::column_values(type, {bytes, sample.cdr.size()}, columns);
}

/// The first field whose values differ; nothing when the type cannot be decoded or only padding
/// differs.
std::optional<std::string> differing_field(const bus::TypeModel& type, const ChainSample& a,
                                           const ChainSample& b) try {
  constexpr bus::ColumnOptions kAllElements{96};  // the longest sequence of the chain: contacts
  const auto names = bus::column_names(type, kAllElements);
  const auto in_a = values(type, a, kAllElements);
  const auto in_b = values(type, b, kAllElements);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (in_a[i] != in_b[i] && names[i] != "header.stamp_ns") {
      return names[i] + ": " + in_a[i] + " and " + in_b[i];
    }
  }
  return std::nullopt;
} catch (const bus::Error&) {
  return std::nullopt;
}

std::string differing_bytes(const ChainSample& a, const ChainSample& b) {
  const std::size_t shorter = std::min(a.cdr.size(), b.cdr.size());
  std::size_t at = 0;
  while (at < shorter &&
         (a.cdr[at] == b.cdr[at] || (at >= logger::kStampBegin && at < logger::kStampEnd))) {
    ++at;
  }
  return "byte " + std::to_string(at) + " (of " + std::to_string(a.cdr.size()) + " and " +
         std::to_string(b.cdr.size()) + ")";
}

std::string describe(const std::optional<bus::TypeModel>& type, const ChainSample& a,
                     const ChainSample& b) {
  std::optional<std::string> field;
  if (type) field = differing_field(*type, a, b);
  return place(a) + ": " + field.value_or(differing_bytes(a, b));
}

/// Which log has samples the other has not.
std::string only_in(const char* log, const ChainSample& first, std::size_t count) {
  return place(first) + ": only " + log + " has it and " + std::to_string(count - 1) +
         " more of this trial";
}

class Comparer {
 public:
  Comparer(std::optional<bus::TypeModel> type, TopicComparison& result)
      : type_(std::move(type)), result_(result) {}

  /// Stops at the first difference.
  void compare(const std::vector<ChainSample>& a, const std::vector<ChainSample>& b) {
    const std::size_t shared = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < shared; ++i) {
      const bool same_place = a[i].header.tick == b[i].header.tick &&
                              a[i].header.sim_time_ns == b[i].header.sim_time_ns;
      if (!same_place) {
        result_.difference =
            "the first has " + place(a[i]) + " where the second has " + place(b[i]);
        return;
      }
      if (!equal_but_stamp(a[i], b[i])) {
        result_.difference = describe(type_, a[i], b[i]);
        return;
      }
      ++result_.equal_samples;
    }
    if (a.size() > shared) result_.difference = only_in("the first", a[shared], a.size() - shared);
    if (b.size() > shared) result_.difference = only_in("the second", b[shared], b.size() - shared);
  }

 private:
  std::optional<bus::TypeModel> type_;
  TopicComparison& result_;
};

}  // namespace

const std::vector<std::string>& chain_topics() {
  static const std::vector<std::string> topics = {"scarab/robot_state",   "scarab/behaviour",
                                                  "scarab/joint_command", "scarab/neural_activity",
                                                  "scarab/world_state",   "scarab/robot_sensors"};
  return topics;
}

TopicComparison compare_topic(const mcap::Reader& a, const mcap::Reader& b,
                              const std::string& topic) {
  TopicComparison result;
  result.topic = topic;
  std::optional<bus::TypeModel> type = find_type(a, topic);
  if (!type) type = find_type(b, topic);
  if (type && !begins_with_header(*type)) {
    throw mcap::Error(topic + ": its samples have no header to compare them by");
  }
  const TrialSamples in_a = load_trial_samples(a, topic);
  const TrialSamples in_b = load_trial_samples(b, topic);
  std::set<std::uint32_t> trials;
  for (const auto& [trial, samples] : in_a) trials.insert(trial);
  for (const auto& [trial, samples] : in_b) trials.insert(trial);
  Comparer comparer(std::move(type), result);
  const std::vector<ChainSample> none;
  for (const std::uint32_t trial : trials) {
    const auto from_a = in_a.find(trial);
    const auto from_b = in_b.find(trial);
    comparer.compare(from_a == in_a.end() ? none : from_a->second,
                     from_b == in_b.end() ? none : from_b->second);
    if (!result.difference.empty()) break;
  }
  return result;
}

}  // namespace scarab::log
