#include "services/logger/log_file.hpp"

#include <unistd.h>

#include <algorithm>

#include "common/bus/clock.hpp"
#include "services/logger/attachments.hpp"
#include "services/logger/host_facts.hpp"
#include "services/logger/utc_time.hpp"

namespace scarab::logger {
namespace {

bool is_free(const std::filesystem::path& path) {
  return !std::filesystem::exists(path) && !std::filesystem::exists(path.string() + ".active");
}

mcap::WriterOptions writer_options(const LoggerConfig& config) {
  mcap::WriterOptions options;
  options.chunk_size_bytes = config.chunk_size_kib * 1024U;
  options.chunk_time = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(config.chunk_time_s));
  options.compression = config.compression;
  options.compression_level = config.compression_level;
  options.library = std::string("scarab ") + SCARAB_VERSION;
  options.sync_on_close = config.sync_on_close;
  return options;
}

/// What this recorder runs with, unless the run's configuration has it already.
void add_own_configuration(const LoggerConfig& config, std::vector<mcap::Attachment>& attachments) {
  const std::string name = "config/logger.yaml";
  const bool known = std::any_of(attachments.begin(), attachments.end(),
                                 [&](const auto& given) { return given.name == name; });
  if (known) return;
  const std::string text = dump_config(config);
  const auto now = static_cast<std::uint64_t>(bus::now_ns());
  attachments.push_back({now, 0, name, "application/yaml", mcap::Bytes(text.begin(), text.end())});
}

}  // namespace

std::filesystem::path free_name(const std::filesystem::path& wanted) {
  std::filesystem::path name = wanted;
  for (int number = 2; !is_free(name); ++number) {
    name = wanted.parent_path() /
           (wanted.stem().string() + "-" + std::to_string(number) + wanted.extension().string());
  }
  return name;
}

std::filesystem::path part_name(const std::filesystem::path& output, Split split,
                                std::uint32_t trial) {
  if (split == Split::kRun) return output;
  std::string number = std::to_string(trial);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  return output.parent_path() /
         (output.stem().string() + "-" + number + output.extension().string());
}

LogFiles::LogFiles(const LoggerOptions& options, const LoggerConfig& config)
    : options_(options),
      config_(config),
      recording_(utc_now() + "-" + host_name() + "-" + std::to_string(::getpid())) {}

std::unique_ptr<mcap::Writer> LogFiles::open(const Part& part) const {
  auto attachments = load_attachments(options_.attach, options_.service.run_dir);
  add_own_configuration(config_, attachments);
  const auto name = free_name(part_name(options_.output, config_.split, part.trial));
  auto writer = std::make_unique<mcap::Writer>(name, writer_options(config_));
  for (const mcap::Attachment& attachment : attachments) {
    writer->attach(attachment);
  }
  writer->add_metadata({"scarab.recording",
                        {{"version", SCARAB_VERSION},
                         {"recording", recording_},
                         {"part", std::to_string(part.number)},
                         {"started", utc_now()},
                         {"domain", std::to_string(options_.service.bus.domain)}}});
  writer->add_metadata(host_metadata());
  return writer;
}

std::unique_ptr<LogSeries> open_series(const LoggerOptions& options, const LoggerConfig& config) {
  const auto folder = options.output.parent_path();
  SeriesLimits limits;
  limits.file_per_trial = config.split == Split::kTrial;
  limits.file_size_bytes = config.file_size_mib << 20U;
  limits.file_time = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(config.file_time_s));
  return std::make_unique<LogSeries>(
      [files = LogFiles(options, config)](const Part& part) { return files.open(part); }, limits,
      DiskSpace([folder] { return free_bytes(folder); }, config.free_disk_mib << 20U));
}

}  // namespace scarab::logger
