#include "tools/log/info.hpp"

#include <cstdlib>
#include <iomanip>

#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;

/// A line of a block: name, value.
std::ostream& item(std::ostream& out, const std::string& name) {
  return out << "  " << std::left << std::setw(12) << name << ' ';
}

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

double span_s(std::uint64_t start_ns, std::uint64_t end_ns) {
  return static_cast<double>(end_ns - start_ns) / kNsPerS;
}

void print_span(std::uint64_t start_ns, std::uint64_t end_ns, std::ostream& out) {
  item(out, "from") << utc_text(start_ns) << '\n';
  item(out, "to") << utc_text(end_ns) << "  (" << fixed_text(span_s(start_ns, end_ns), 3)
                  << " s)\n";
}

void print_file(const FileFacts& file, std::ostream& out) {
  out << file.path << '\n';
  item(out, "library") << file.library << (file.profile.empty() ? "" : ", profile " + file.profile)
                       << '\n';
  item(out, "closed") << (file.closed ? "yes" : "no: cut, or still being written") << '\n';
  if (file.bytes_lost > 0) {
    item(out, "lost") << "its last " << counted(file.bytes_lost, "byte") << ": no whole record\n";
  }
  if (!file.damage.empty()) item(out, "damaged") << file.damage << '\n';
  item(out, "size") << size_text(file.size) << " in " << counted(file.chunks, "chunk") << " of "
                    << size_text(file.chunk_bytes) << " uncompressed";
  if (!file.compressions.empty()) out << " (compression: " << joined(file.compressions) << ")";
  out << '\n';
  item(out, "messages") << file.messages << '\n';
  if (file.messages > 0) print_span(file.start_ns, file.end_ns, out);
}

void print_trials(const LogFacts& facts, std::ostream& out) {
  out << "trials: " << facts.trials.size() << '\n';
  for (const TrialFacts& trial : facts.trials) {
    item(out, "trial " + std::to_string(trial.trial));
    if (!trial.strategy.empty()) out << trial.strategy << ", ";
    if (trial.ticks == 0) {
      out << "no tick of it\n";
      continue;
    }
    out << "ticks " << trial.first_tick << " to " << trial.last_tick << ", "
        << fixed_text(trial.sim_time_s, 1) << " s simulated";
    if (trial.real_time) out << (*trial.real_time ? ", in real time" : ", in lockstep");
    out << '\n';
  }
}

/// The policies by which readers match, and what of the others is not usual.
std::string qos_text(const std::map<std::string, std::string>& qos) {
  std::string text;
  const auto add = [&](const std::string& word, const std::string& name, const std::string& usual) {
    const auto found = qos.find(word);
    if (found == qos.end() || found->second == usual) return;
    text += (text.empty() ? "" : ", ") + name + found->second;
  };
  const auto add_time = [&](const std::string& word, const std::string& name) {
    const auto found = qos.find(word);
    if (found == qos.end()) return;
    text +=
        ", " + name + fixed_text(std::strtod(found->second.c_str(), nullptr) / kNsPerS, 3) + " s";
  };
  add("reliability", "", "");
  add("durability", "", "");
  add("ownership", "ownership ", "shared");
  add("ownership_strength", "strength ", "0");
  add("liveliness", "liveliness ", "automatic");
  add_time("lease_ns", "lease ");
  add_time("deadline_ns", "deadline ");
  add("representation", "", "xcdr1");
  for (const auto& [word, value] : qos) {
    if (word.rfind("partition.", 0) == 0) add(word, "partition ", "");
  }
  return text;
}

void print_topic(const TopicFacts& topic, std::ostream& out) {
  out << "  " << std::left << std::setw(26) << topic.topic << ' ' << std::setw(24)
      << (topic.type.empty() ? "(no schema)" : topic.type) << ' ' << std::right << std::setw(9)
      << topic.messages << ' ' << std::setw(9) << fixed_text(topic.rate_hz, 1) << "/s";
  if (!topic.writers.empty()) out << "  by " << topic.writers;
  if (!topic.qos.empty()) out << ", " << qos_text(topic.qos);
  if (topic.dropped > 0) out << "  (" << topic.dropped << " dropped)";
  out << '\n';
  if (!topic.no_type.empty()) out << "    shown as bytes: " << topic.no_type << '\n';
}

void print_extras(const FileFacts& file, const std::string& of, std::ostream& out) {
  if (!file.attachments.empty()) out << "attachments" << of << '\n';
  for (const mcap::AttachmentIndex& attachment : file.attachments) {
    out << "  " << std::left << std::setw(40) << attachment.name << ' '
        << size_text(attachment.data_size) << '\n';
  }
  for (const mcap::Metadata& record : file.metadata) {
    out << record.name << of << '\n';
    for (const auto& [key, value] : record.entries) item(out, key) << value << '\n';
  }
}

}  // namespace

void print_info(const LogFacts& facts, std::ostream& out) {
  for (const FileFacts& file : facts.files) print_file(file, out);
  const bool several = facts.files.size() > 1;
  if (several) {
    out << "all " << facts.files.size() << " files\n";
    item(out, "messages") << facts.messages << '\n';
    if (facts.messages > 0) print_span(facts.start_ns, facts.end_ns, out);
  }
  if (facts.dropped > 0) {
    out << "dropped: " << counted(facts.dropped, "sample") << " that the recorder could not keep\n";
  }
  print_trials(facts, out);
  out << "topics: " << facts.topics.size() << '\n';
  for (const TopicFacts& topic : facts.topics) print_topic(topic, out);
  for (const FileFacts& file : facts.files) {
    print_extras(file, several ? " of " + file.path : "", out);
  }
}

void warn_if_cut(const Log& log, std::ostream& out) {
  for (const auto& reader : log.files()) {
    if (reader->closed() && reader->damage().empty()) continue;
    out << "scarab-log: " << reader->path().string() << ": "
        << (reader->closed() ? "damaged" : "not closed (cut, or still being written)");
    if (reader->bytes_lost() > 0) {
      out << ", its last " << reader->bytes_lost() << " bytes are no whole record";
    }
    if (!reader->damage().empty()) out << ", " << reader->damage();
    out << "; `scarab-log recover` makes a whole file of what can be read\n";
  }
}

}  // namespace scarab::log
