#include "common/bus/raw_qos.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <tuple>

#include "common/bus/error.hpp"
#include "common/bus/policy_text.hpp"

namespace scarab::bus {

namespace {

using Words = std::map<std::string, std::string>;
using Nanoseconds = std::optional<std::chrono::nanoseconds>;

// How long a write waits for slow readers before it fails.
constexpr dds_duration_t kMaxBlocking = DDS_SECS(1);

Nanoseconds finite(dds_duration_t duration) {
  return duration == DDS_INFINITY ? Nanoseconds() : std::chrono::nanoseconds(duration);
}

dds_duration_t duration(const Nanoseconds& from) { return from ? from->count() : DDS_INFINITY; }

template <class Number>
Number number(const std::string& word, const std::string& text, Number least) {
  Number value{};
  const char* last = text.data() + text.size();
  const auto result = std::from_chars(text.data(), last, value);
  if (result.ec != std::errc() || result.ptr != last || value < least) {
    throw Error("QoS " + word + ": '" + text + "' is no number of it");
  }
  return value;
}

/// Reads words; what is absent leaves its policy as it is.
class Reading {
 public:
  explicit Reading(const Words& words) : words_(words) {}

  const std::string* find(const std::string& word) const {
    const auto found = words_.find(word);
    return found == words_.end() ? nullptr : &found->second;
  }
  /// One of the values that `to_text` gives for the kinds.
  template <class Kind>
  void kind(const std::string& word, std::initializer_list<Kind> kinds, Kind& out) const {
    const std::string* text = find(word);
    if (text == nullptr) return;
    const auto named = [&](Kind candidate) { return to_text(candidate) == *text; };
    const auto* found = std::find_if(kinds.begin(), kinds.end(), named);
    if (found == kinds.end()) throw Error("QoS " + word + ": '" + *text + "' is none of its kinds");
    out = *found;
  }
  void lease(const std::string& word, Nanoseconds& out) const {
    const std::string* text = find(word);
    if (text != nullptr) {
      out = std::chrono::nanoseconds(number<std::int64_t>(word, *text, 0));
    }
  }

 private:
  const Words& words_;
};

std::string partition_word(std::size_t i) { return "partition." + std::to_string(i); }

void read_history(const Reading& words, RawQos& qos) {
  const std::string* text = words.find("history");
  if (text != nullptr) qos.history_depth = *text == "all" ? 0 : number("history", *text, 1);
}

void read_representation(const Reading& words, RawQos& qos) {
  const std::string* text = words.find("representation");
  if (text == nullptr) return;
  if (*text != "xcdr1" && *text != "xcdr2") {
    throw Error("QoS representation: '" + *text + "' is none of its kinds");
  }
  qos.xcdr2 = *text == "xcdr2";
}

bool writes_xcdr2(const dds_qos_t& announced) {
  std::uint32_t count = 0;
  dds_data_representation_id_t* ids = nullptr;
  if (!dds_qget_data_representation(&announced, &count, &ids) || count == 0) return false;
  const bool found = ids[0] == DDS_DATA_REPRESENTATION_XCDR2;  // the first is the one it writes
  dds_free(ids);
  return found;
}

}  // namespace

bool operator==(const RawQos& a, const RawQos& b) {
  const auto all = [](const RawQos& q) {
    return std::tie(q.reliability, q.durability, q.ownership, q.ownership_strength, q.liveliness,
                    q.liveliness_lease, q.deadline, q.history_depth, q.late_joiner_depth,
                    q.partitions, q.xcdr2);
  };
  return all(a) == all(b);
}

RawQos raw_qos_of(const dds_qos_t& announced) {
  RawQos out;
  dds_duration_t lease = DDS_INFINITY;
  dds_duration_t deadline = DDS_INFINITY;
  out.reliability = reliability_of(announced);
  out.durability = std::min(durability_of(announced), DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qget_ownership(&announced, &out.ownership);
  dds_qget_ownership_strength(&announced, &out.ownership_strength);
  dds_qget_liveliness(&announced, &out.liveliness, &lease);
  dds_qget_deadline(&announced, &deadline);
  out.liveliness_lease = finite(lease);
  out.deadline = finite(deadline);
  out.partitions = partitions_of(announced);
  if (out.partitions == std::vector<std::string>{""}) out.partitions.clear();
  out.xcdr2 = writes_xcdr2(announced);
  return out;
}

std::map<std::string, std::string> to_words(const RawQos& qos) {
  Words words{
      {"reliability", to_text(qos.reliability)},
      {"durability", to_text(qos.durability)},
      {"ownership", to_text(qos.ownership)},
      {"ownership_strength", std::to_string(qos.ownership_strength)},
      {"liveliness", to_text(qos.liveliness)},
      {"history", qos.history_depth == 0 ? "all" : std::to_string(qos.history_depth)},
      {"representation", qos.xcdr2 ? "xcdr2" : "xcdr1"},
  };
  if (qos.liveliness_lease) words["lease_ns"] = std::to_string(qos.liveliness_lease->count());
  if (qos.deadline) words["deadline_ns"] = std::to_string(qos.deadline->count());
  for (std::size_t i = 0; i < qos.partitions.size(); ++i) {
    words[partition_word(i)] = qos.partitions[i];
  }
  return words;
}

RawQos raw_qos_from_words(const std::map<std::string, std::string>& words) {
  const Reading reading(words);
  RawQos out;
  reading.kind("reliability", {DDS_RELIABILITY_BEST_EFFORT, DDS_RELIABILITY_RELIABLE},
               out.reliability);
  reading.kind("durability", {DDS_DURABILITY_VOLATILE, DDS_DURABILITY_TRANSIENT_LOCAL},
               out.durability);
  reading.kind("ownership", {DDS_OWNERSHIP_SHARED, DDS_OWNERSHIP_EXCLUSIVE}, out.ownership);
  reading.kind("liveliness",
               {DDS_LIVELINESS_AUTOMATIC, DDS_LIVELINESS_MANUAL_BY_PARTICIPANT,
                DDS_LIVELINESS_MANUAL_BY_TOPIC},
               out.liveliness);
  reading.lease("lease_ns", out.liveliness_lease);
  reading.lease("deadline_ns", out.deadline);
  if (const std::string* strength = reading.find("ownership_strength")) {
    out.ownership_strength = number("ownership_strength", *strength, INT32_MIN);
  }
  read_history(reading, out);
  read_representation(reading, out);
  while (const auto* name = reading.find(partition_word(out.partitions.size()))) {
    out.partitions.push_back(*name);
  }
  return out;
}

Qos dds_qos_of(const RawQos& from) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), from.reliability, kMaxBlocking);
  dds_qset_durability(qos.get(), from.durability);
  dds_qset_ownership(qos.get(), from.ownership);
  if (from.ownership == DDS_OWNERSHIP_EXCLUSIVE) {
    dds_qset_ownership_strength(qos.get(), from.ownership_strength);
  }
  dds_qset_liveliness(qos.get(), from.liveliness, duration(from.liveliness_lease));
  dds_qset_deadline(qos.get(), duration(from.deadline));
  const bool all = from.history_depth == 0;
  const auto kind = all ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST;
  const int depth = all ? DDS_LENGTH_UNLIMITED : from.history_depth;
  dds_qset_history(qos.get(), kind, depth);
  const auto late = from.late_joiner_depth;
  dds_qset_durability_service(qos.get(), 0, late ? DDS_HISTORY_KEEP_LAST : kind,
                              late.value_or(depth), DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  std::vector<const char*> names;
  for (const std::string& name : from.partitions) names.push_back(name.c_str());
  if (!names.empty()) {
    dds_qset_partition(qos.get(), static_cast<std::uint32_t>(names.size()), names.data());
  }
  const dds_data_representation_id_t representation =
      from.xcdr2 ? DDS_DATA_REPRESENTATION_XCDR2 : DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &representation);
  return qos;
}

}  // namespace scarab::bus
