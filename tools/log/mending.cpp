#include "tools/log/mending.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>

#include "common/mcap/reader.hpp"
#include "tools/log/unfinished_file.hpp"
#include "tools/log/words.hpp"

namespace scarab::log {
namespace {

constexpr const char* kActive = ".active";

bool is_active(const std::filesystem::path& path) { return path.extension() == kActive; }

bool is_whole(const std::filesystem::path& path, const mcap::Progress& progress) {
  const mcap::Reader reader(path, mcap::Access::kScan, progress);
  return reader.closed() && reader.damage().empty();
}

}  // namespace

/// Linux grants a read lease on a file only while nobody has it open for writing.
bool is_being_written(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (file < 0) return false;
  // Whoever opens it meanwhile for writing breaks the lease with a signal: one that nobody minds.
  ::fcntl(file, F_SETSIG, SIGURG);
  const bool refused = ::fcntl(file, F_SETLEASE, F_RDLCK) != 0 && errno == EAGAIN;
  ::close(file);
  return refused;
}

std::filesystem::path mended_name(const std::filesystem::path& cut) {
  if (is_active(cut)) return cut.parent_path() / cut.stem();
  return cut.parent_path() / (cut.stem().string() + ".mended" + cut.extension().string());
}

std::vector<std::filesystem::path> cut_logs(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(directory)) {
    const bool is_log = entry.path().stem().extension() == ".mcap" && is_active(entry.path());
    if (is_log && entry.is_regular_file()) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

Mending mend(const std::filesystem::path& cut, const std::optional<std::filesystem::path>& to,
             const mcap::Progress& progress) {
  if (is_being_written(cut)) {
    throw mcap::FileError(cut.string() + " is being written; stop its recorder first");
  }
  Mending mending;
  if (!to && !is_active(cut) && is_whole(cut, progress)) return mending;
  mending.to = to ? *to : mended_name(cut);
  mcap::WriterOptions options;
  options.sync_on_close = !to;
  const UnfinishedFile unfinished(mcap::unfinished_path(mending.to));
  mending.recovery = mcap::recover(cut, mending.to, options, progress);
  if (!to && is_active(cut) && mending.recovery.damaged == 0) {
    mending.removed = std::filesystem::remove(cut);
  }
  return mending;
}

std::string to_string(const std::filesystem::path& cut, const Mending& mending) {
  if (mending.to.empty()) return cut.string() + ": is whole, nothing to mend";
  const mcap::Recovery& recovery = mending.recovery;
  std::string text = mending.to.string() + ": " + counted(recovery.kept.message_count, "message") +
                     " of " + counted(recovery.kept.chunk_count, "chunk") + ", " +
                     counted(recovery.kept.attachment_count, "attachment");
  if (recovery.kept.message_count > 0) {
    text += ", the last of " + utc_text(recovery.kept.end_time_ns);
  }
  if (!recovery.was_closed) text += "\n  lost: what its recorder had not written yet when it ended";
  if (recovery.was_closed && recovery.damaged == 0) text += "\n  nothing lost: it had been closed";
  if (recovery.bytes_lost > 0) {
    text +=
        ", and " + counted(recovery.bytes_lost, "byte") + " at the end that are no whole record";
  }
  if (recovery.damaged > 0) {
    text += "\n  left out: " + counted(recovery.damaged, "damaged record") +
            ", the first: " + recovery.damage;
  }
  for (const auto& [topic, count] : recovery.missing) {
    text += "\n  missing: " + counted(count, "message") + " of " + topic +
            ", by the gaps in their numbers";
  }
  text += mending.removed ? "\n  removed: " : "\n  kept as it was: ";
  return text + cut.string();
}

}  // namespace scarab::log
