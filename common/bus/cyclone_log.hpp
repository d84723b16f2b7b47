#pragma once

#include <mutex>
#include <string>

namespace scarab::bus {

/// While it lives, Cyclone's messages are collected here and not printed: Cyclone tells the cause
/// of a failure only in its log. The log sink belongs to the process, so captures wait for each
/// other.
class CycloneLog {
 public:
  CycloneLog();
  ~CycloneLog();
  CycloneLog(const CycloneLog&) = delete;
  CycloneLog& operator=(const CycloneLog&) = delete;

  /// What Cyclone said, in one line; messages separated by "; ".
  std::string text() const;

 private:
  std::unique_lock<std::mutex> turn_;
  mutable std::mutex mutex_;
  std::string text_;
};

}  // namespace scarab::bus
