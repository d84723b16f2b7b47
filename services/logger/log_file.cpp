#include "services/logger/log_file.hpp"

#include <unistd.h>

#include <array>
#include <ctime>

#include "common/bus/clock.hpp"
#include "services/logger/attachments.hpp"

namespace scarab::logger {
namespace {

bool is_free(const std::filesystem::path& path) {
  return !std::filesystem::exists(path) && !std::filesystem::exists(path.string() + ".active");
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  const std::size_t size = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), size};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
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

}  // namespace

std::filesystem::path free_name(const std::filesystem::path& wanted) {
  std::filesystem::path name = wanted;
  for (int number = 2; !is_free(name); ++number) {
    name = wanted.parent_path() /
           (wanted.stem().string() + "-" + std::to_string(number) + wanted.extension().string());
  }
  return name;
}

std::unique_ptr<mcap::Writer> open_log(const LoggerOptions& options, const LoggerConfig& config) {
  const auto attachments = load_attachments(options.attach, options.service.run_dir);
  auto writer = std::make_unique<mcap::Writer>(free_name(options.output), writer_options(config));
  for (const mcap::Attachment& attachment : attachments) {
    writer->attach(attachment);
  }
  writer->add_metadata({"scarab.recording",
                        {{"version", SCARAB_VERSION},
                         {"host", host_name()},
                         {"started", utc_now()},
                         {"domain", std::to_string(options.service.bus.domain)}}});
  return writer;
}

mcap::Metadata closing_metadata(const RecordingState& state) {
  return {"scarab.recorded",
          {{"closed", utc_now()},
           {"trials", std::to_string(state.progress.trials())},
           {"missed_ticks", std::to_string(state.progress.missed_ticks())},
           {"messages", std::to_string(state.messages)},
           {"bytes", std::to_string(state.bytes)}}};
}

}  // namespace scarab::logger
