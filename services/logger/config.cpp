#include "services/logger/config.hpp"

#include <array>
#include <string_view>
#include <utility>

#include "common/config/config.hpp"

namespace scarab::mcap {

constexpr std::array<std::pair<std::string_view, Compression>, 3> enum_names(Compression) {
  return {{{"none", Compression::kNone}, {"lz4", Compression::kLz4}, {"zstd", Compression::kZstd}}};
}

}  // namespace scarab::mcap

namespace scarab::logger {

constexpr std::array<std::pair<std::string_view, Split>, 2> enum_names(Split) {
  return {{{"run", Split::kRun}, {"trial", Split::kTrial}}};
}

template <class Fields>
void visit_fields(Fields& f, LoggerConfig& c) {
  f.optional("split", c.split);
  f.optional("file_size_mib", c.file_size_mib, config::Range{0, 1 << 20});
  f.optional("file_time_s", c.file_time_s, config::Range{0, 1e7});
  f.optional("free_disk_mib", c.free_disk_mib, config::Range{0, 1 << 30});
  f.optional("chunk_size_kib", c.chunk_size_kib, config::Range{1, 65536});
  f.optional("chunk_time_s", c.chunk_time_s, config::Range{0.001, 60});
  f.optional("compression", c.compression);
  f.optional("compression_level", c.compression_level, config::Range{1, 19});
  f.optional("queue_mib", c.queue_mib, config::Range{1, 4096});
  f.optional("take_interval_s", c.take_interval_s, config::Range{0, 0.1});
  f.optional("sync_on_close", c.sync_on_close);
}

LoggerConfig load_config(const std::filesystem::path& path) {
  return config::load<LoggerConfig>(path);
}

std::string dump_config(const LoggerConfig& config) { return config::dump(config); }

std::string config_schema() { return config::schema<LoggerConfig>("Scarab: config/logger"); }

}  // namespace scarab::logger
