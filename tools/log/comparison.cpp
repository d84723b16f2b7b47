#include "tools/log/comparison.hpp"

#include <set>
#include <sstream>

#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;

/// Walks the two logs' samples of one group side by side.
class GroupComparison {
 public:
  GroupComparison(const SampleComparison& samples, bool have_header, std::string instance,
                  TopicComparison& result)
      : samples_(samples),
        have_header_(have_header),
        instance_(std::move(instance)),
        result_(result) {}

  void run(const std::vector<Sample>& a, const std::vector<Sample>& b) {
    std::size_t i = 0;
    std::size_t j = 0;
    while (i < a.size() || j < b.size()) {
      if (j == b.size() || (i < a.size() && have_header_ && place_of(a[i]) < place_of(b[j]))) {
        ++result_.only_in_a;
        note(Difference::Kind::kOnlyInA, a[i], i, {});
        ++i;
      } else if (i == a.size() || (have_header_ && place_of(b[j]) < place_of(a[i]))) {
        ++result_.only_in_b;
        note(Difference::Kind::kOnlyInB, b[j], j, {});
        ++j;
      } else {
        compare(a[i], b[j], i);
        ++i;
        ++j;
      }
    }
  }

 private:
  void compare(const Sample& a, const Sample& b, std::size_t index) {
    const auto found = samples_.difference(a.cdr, b.cdr);
    if (!found) {
      ++result_.equal;
      return;
    }
    ++result_.different;
    note(Difference::Kind::kValue, a, index, *found);
  }

  void note(Difference::Kind kind, const Sample& sample, std::size_t index,
            const FieldDifference& field) {
    if (result_.first) return;
    result_.first = Difference{kind,      have_header_,           sample.header, index,
                               instance_, sample.publish_time_ns, field};
  }

  const SampleComparison& samples_;
  bool have_header_;
  std::string instance_;
  TopicComparison& result_;
};

}  // namespace

TopicComparison compare_topic(const Log& a, const Log& b, const std::string& topic,
                              const Lenience& lenience) {
  TopicComparison result;
  result.topic = topic;
  const LogChannel* in_a = a.find(topic);
  const LogChannel* in_b = b.find(topic);
  const SampleComparison samples(in_a, in_b, lenience);
  const bool have_header = (in_a == nullptr || in_a->has_header) &&
                           (in_b == nullptr || in_b->has_header) &&
                           (in_a != nullptr || in_b != nullptr);
  const TopicSamples groups_a = load_samples(a, topic);
  const TopicSamples groups_b = load_samples(b, topic);
  std::set<SampleGroup> groups;
  for (const auto& [group, of_a] : groups_a) groups.insert(group);
  for (const auto& [group, of_b] : groups_b) groups.insert(group);
  const std::vector<Sample> none;
  for (const SampleGroup& group : groups) {
    const auto of_a = groups_a.find(group);
    const auto of_b = groups_b.find(group);
    GroupComparison(samples, have_header, group.second, result)
        .run(of_a == groups_a.end() ? none : of_a->second,
             of_b == groups_b.end() ? none : of_b->second);
  }
  return result;
}

std::vector<std::string> comparable_topics(const Log& a, const Log& b) {
  std::set<std::string> topics = a.topics();
  topics.merge(b.topics());
  topics.erase("scarab/service_status");
  return {topics.begin(), topics.end()};
}

std::string place(const Difference& difference) {
  std::ostringstream text;
  if (difference.has_header) {
    text << "trial " << difference.header.trial << ", tick " << difference.header.tick << " ("
         << static_cast<double>(difference.header.sim_time_ns) / kNsPerS << " s)";
  } else {
    text << "sample " << difference.index << " (published at "
         << utc_text(difference.publish_time_ns) << ")";
  }
  if (!difference.instance.empty()) text << " of " << difference.instance;
  return text.str();
}

std::string to_string(const Difference& difference, const std::string& a, const std::string& b) {
  switch (difference.kind) {
    case Difference::Kind::kValue:
      return place(difference) + ": " + to_string(difference.field);
    case Difference::Kind::kOnlyInA:
      return place(difference) + ": only in " + a;
    case Difference::Kind::kOnlyInB:
      return place(difference) + ": only in " + b;
  }
  return place(difference);
}

}  // namespace scarab::log
