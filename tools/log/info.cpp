#include "tools/log/info.hpp"

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <map>
#include <sstream>

#include "services/logger/core/sample_header.hpp"

namespace scarab::log {
namespace {

constexpr double kNsPerS = 1e9;

std::string utc(std::uint64_t time_ns) {
  const auto seconds = static_cast<std::time_t>(time_ns / 1'000'000'000U);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::ostringstream text;
  text << std::put_time(&parts, "%Y-%m-%d %H:%M:%S") << '.' << std::setfill('0') << std::setw(3)
       << time_ns / 1'000'000U % 1000U << " UTC";
  return text.str();
}

std::string size_text(std::uint64_t bytes) {
  constexpr double kKilo = 1e3;
  constexpr double kMega = 1e6;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1);
  if (static_cast<double>(bytes) < kKilo) {
    text << bytes << " B";
  } else if (static_cast<double>(bytes) < kMega) {
    text << static_cast<double>(bytes) / kKilo << " kB";
  } else {
    text << static_cast<double>(bytes) / kMega << " MB";
  }
  return text.str();
}

/// A line of the first block: name, value.
std::ostream& item(std::ostream& out, const std::string& name) {
  return out << "  " << std::left << std::setw(13) << name;
}

void print_size(const mcap::Reader& reader, std::ostream& out) {
  std::uint64_t uncompressed = 0;
  for (const mcap::ChunkIndex& chunk : reader.summary().chunks) {
    uncompressed += chunk.uncompressed_size;
  }
  item(out, "size") << size_text(std::filesystem::file_size(reader.path())) << " in "
                    << reader.summary().chunks.size() << " chunks of " << size_text(uncompressed)
                    << " uncompressed\n";
}

double span_s(const mcap::Statistics& statistics) {
  return static_cast<double>(statistics.end_time_ns - statistics.start_time_ns) / kNsPerS;
}

void print_times(const mcap::Statistics& statistics, std::ostream& out) {
  item(out, "messages") << statistics.message_count << '\n';
  if (statistics.message_count == 0) return;
  item(out, "from") << utc(statistics.start_time_ns) << '\n';
  item(out, "to") << utc(statistics.end_time_ns) << "  (" << std::fixed << std::setprecision(3)
                  << span_s(statistics) << " s)\n";
}

void print_trials(const mcap::Reader& reader, std::ostream& out) {
  struct Trial {
    std::uint32_t last_tick = 0;
    double sim_time_s = 0;
  };
  std::map<std::uint32_t, Trial> trials;
  reader.for_each(
      [&](const mcap::Channel&, const mcap::Message& message) {
        const auto header = logger::read_sample_header(message.data.data(), message.data.size());
        if (!header) return;
        Trial& trial = trials[header->trial];
        trial.last_tick = std::max(trial.last_tick, header->tick);
        trial.sim_time_s =
            std::max(trial.sim_time_s, static_cast<double>(header->sim_time_ns) / kNsPerS);
      },
      {"scarab/robot_state"});
  item(out, "trials") << trials.size() << '\n';
  for (const auto& [number, trial] : trials) {
    item(out, "  trial " + std::to_string(number))
        << "ticks to " << trial.last_tick << ", " << std::fixed << std::setprecision(1)
        << trial.sim_time_s << " s simulated\n";
  }
}

void print_topics(const mcap::Reader& reader, std::ostream& out) {
  const mcap::Summary& summary = reader.summary();
  out << "topics\n";
  for (const auto& [id, channel] : summary.channels) {
    const auto counted = summary.statistics.channel_message_counts.find(id);
    const std::uint64_t count =
        counted == summary.statistics.channel_message_counts.end() ? 0 : counted->second;
    const auto schema = summary.schemas.find(channel.schema_id);
    const double span = span_s(summary.statistics);
    out << "  " << std::left << std::setw(26) << channel.topic << std::setw(26)
        << (schema == summary.schemas.end() ? "(no schema)" : schema->second.name) << std::right
        << std::setw(9) << count << ' ' << std::fixed << std::setprecision(1) << std::setw(9)
        << (span > 0 ? static_cast<double>(count) / span : 0.0) << "/s\n";
  }
}

void print_extras(const mcap::Reader& reader, std::ostream& out) {
  if (!reader.summary().attachments.empty()) out << "attachments\n";
  for (const mcap::AttachmentIndex& attachment : reader.summary().attachments) {
    out << "  " << std::left << std::setw(40) << attachment.name << ' '
        << size_text(attachment.data_size) << '\n';
  }
  for (const mcap::MetadataIndex& index : reader.summary().metadata) {
    out << index.name << '\n';
    for (const auto& [key, value] : reader.metadata(index).entries) {
      item(out, key) << value << '\n';
    }
  }
}

}  // namespace

void print_info(const mcap::Reader& reader, std::ostream& out) {
  out << reader.path().string() << '\n';
  item(out, "library") << reader.header().library << '\n';
  item(out, "closed") << (reader.closed() ? "yes" : "no: cut, or still being written") << '\n';
  if (!reader.damage().empty()) item(out, "damaged") << reader.damage() << '\n';
  print_size(reader, out);
  print_times(reader.summary().statistics, out);
  print_trials(reader, out);
  print_topics(reader, out);
  print_extras(reader, out);
}

void warn_if_cut(const mcap::Reader& reader, std::ostream& out) {
  if (reader.closed() && reader.damage().empty()) return;
  out << "scarab-log: " << reader.path().string() << ": "
      << (reader.closed() ? "damaged" : "not closed (cut, or still being written)");
  if (reader.bytes_lost() > 0)
    out << ", its last " << reader.bytes_lost() << " bytes are no whole record";
  if (!reader.damage().empty()) out << ", " << reader.damage();
  out << "; `scarab-log recover` makes a whole file of what can be read\n";
}

}  // namespace scarab::log
