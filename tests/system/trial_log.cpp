#include "tests/system/trial_log.hpp"

#include <map>
#include <optional>
#include <stdexcept>

#include "common/bus/cdr.hpp"
#include "common/bus/topics.hpp"
#include "common/mcap/reader.hpp"
#include "common/mcap/writer.hpp"

namespace scarab::test {
namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kHeaderSize = 24;  // trial, tick, sim_time_ns, stamp_ns

sample::ByteView bytes_of(const mcap::Message& message) {
  return {reinterpret_cast<const std::byte*>(message.data.data()), message.data.size()};
}

/// Ids of the same schemas and channels in another file.
std::map<std::uint16_t, std::uint16_t> copy_channels(const mcap::Summary& summary,
                                                     mcap::Writer& writer) {
  std::map<std::uint16_t, std::uint16_t> ids;
  for (const auto& [id, channel] : summary.channels) {
    const auto& schema = summary.schemas.at(channel.schema_id);
    ids[id] = writer.add_channel(writer.add_schema(schema.name, schema.encoding, schema.data),
                                 channel.topic, channel.message_encoding);
  }
  return ids;
}

}  // namespace

TrialLog read_trial(const std::filesystem::path& log) {
  TrialLog trial;
  std::optional<scarab_Mode> mode;
  const mcap::Reader reader(log);
  reader.for_each(
      [&](const mcap::Channel& channel, const mcap::Message& message) {
        if (channel.topic == bus::kRobotState.name) {
          const auto state = bus::decode<scarab_RobotState>(bytes_of(message));
          const scarab_Header& header = state->header;
          if (!trial.ticks.empty() && trial.ticks.back() == header.tick) return;
          trial.ticks.push_back(header.tick);
          trial.stamps_ns.push_back(header.stamp_ns);
        } else {
          const auto behaviour = bus::decode<scarab_Behaviour>(bytes_of(message));
          if (mode && *mode != behaviour->mode) ++trial.mode_changes;
          mode = behaviour->mode;
        }
      },
      {bus::kRobotState.name, bus::kBehaviour.name});
  return trial;
}

bool contiguous_from_zero(const std::vector<std::uint32_t>& ticks) {
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if (ticks[i] != i) return false;
  }
  return !ticks.empty();
}

Finished compare(const std::filesystem::path& a, const std::filesystem::path& b) {
  return run({program("scarab-log"), "diff", a, b});
}

void copy_with_changed_byte(const std::filesystem::path& from, const std::filesystem::path& to,
                            const std::string& topic, std::uint32_t n, std::size_t offset) {
  const mcap::Reader reader(from);
  mcap::WriterOptions options;
  options.overwrite = true;
  mcap::Writer writer(to, options);
  const auto ids = copy_channels(reader.summary(), writer);
  std::uint32_t seen = 0;
  bool changed = false;
  reader.for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
    mcap::Message copy = message;
    mcap::Bytes bytes = mcap::copy_of(message.data);
    if (channel.topic == topic && seen++ == n) {
      bytes.at(kEncapsulation + kHeaderSize + offset) ^= 1U;
      changed = true;
    }
    copy.channel_id = ids.at(channel.id);
    copy.data = bytes;
    writer.write(copy);
  });
  writer.close();
  if (!changed) throw std::runtime_error(from.string() + ": too few samples of " + topic);
}

}  // namespace scarab::test
