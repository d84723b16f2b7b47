#pragma once

#include <filesystem>

namespace scarab::log {

/// A file that is being written under a name of its own: while this lives, Ctrl-C and SIGTERM
/// remove it before they end the process (exit code 130), and so does an exception. One at a time.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(std::filesystem::path path);
  /// Removes what is there under that name: nothing, once it was finished and renamed.
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  std::filesystem::path path_;
};

}  // namespace scarab::log
