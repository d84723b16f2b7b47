#include "tools/log/comparison_report.hpp"

#include <algorithm>

#include "common/config/json_object.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

std::uint64_t samples_of(const TopicComparison& topic) {
  return topic.equal + topic.different + topic.only_in_a + topic.only_in_b;
}

std::string text_of(const TopicComparison& topic, const std::string& a, const std::string& b) {
  if (topic.is_equal()) return counted(topic.equal, "sample") + " equal";
  std::string text =
      std::to_string(topic.equal) + " of " + counted(samples_of(topic), "sample") + " equal";
  if (topic.different > 0) text += ", " + std::to_string(topic.different) + " different";
  if (topic.only_in_a > 0) text += ", " + std::to_string(topic.only_in_a) + " only in " + a;
  if (topic.only_in_b > 0) text += ", " + std::to_string(topic.only_in_b) + " only in " + b;
  return text + "\n  first: " + to_string(*topic.first, a, b);
}

std::string json_of(const Difference& first) {
  config::JsonObject object;
  if (first.has_header) {
    object.number("trial", first.header.trial)
        .number("tick", first.header.tick)
        .raw("sim_time_ns", std::to_string(first.header.sim_time_ns));
  } else {
    object.number("index", first.index)
        .text("publish_time_ns", std::to_string(first.publish_time_ns));
  }
  if (!first.instance.empty()) object.raw("key", "{" + first.instance + "}");
  if (first.kind == Difference::Kind::kOnlyInA) return object.text("only_in", "a").str();
  if (first.kind == Difference::Kind::kOnlyInB) return object.text("only_in", "b").str();
  const auto value = [](const std::string& json) { return json.empty() ? "null" : json; };
  return object.text("field", first.field.field)
      .raw("a", value(first.field.a))
      .raw("b", value(first.field.b))
      .str();
}

}  // namespace

bool LogComparison::is_equal() const {
  return std::all_of(topics.begin(), topics.end(),
                     [](const TopicComparison& topic) { return topic.is_equal(); });
}

std::uint64_t LogComparison::samples() const {
  std::uint64_t sum = 0;
  for (const TopicComparison& topic : topics) sum += samples_of(topic);
  return sum;
}

void print_text(const LogComparison& comparison, std::ostream& out) {
  std::uint64_t equal = 0;
  std::size_t different = 0;
  for (const TopicComparison& topic : comparison.topics) {
    out << topic.topic << ": " << text_of(topic, comparison.a, comparison.b) << '\n';
    equal += topic.equal;
    if (!topic.is_equal()) ++different;
  }
  out << "summary: "
      << (different == 0 ? "equal"
                         : std::to_string(different) + " of " +
                               counted(comparison.topics.size(), "topic") + " different")
      << ", " << equal << " of " << counted(comparison.samples(), "sample") << " equal\n";
}

void print_json(const LogComparison& comparison, std::ostream& out) {
  std::vector<std::string> topics;
  for (const TopicComparison& topic : comparison.topics) {
    config::JsonObject object;
    object.text("topic", topic.topic)
        .number("equal", topic.equal)
        .number("different", topic.different)
        .number("only_in_a", topic.only_in_a)
        .number("only_in_b", topic.only_in_b);
    if (topic.first) object.raw("first", json_of(*topic.first));
    topics.push_back(object.str());
  }
  out << "{\n  \"a\": " << config::in_json_quotes(comparison.a)
      << ",\n  \"b\": " << config::in_json_quotes(comparison.b)
      << ",\n  \"equal\": " << (comparison.is_equal() ? "true" : "false")
      << ",\n  \"topics\": " << config::json_lines(topics, "    ") << "\n}\n";
}

}  // namespace scarab::log
