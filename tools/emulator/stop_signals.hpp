#pragma once

namespace scarab::emulator {

/// SIGINT and SIGTERM as something to poll. Needs a runtime::SignalBlock made before.
class StopSignals {
 public:
  /// Throws std::runtime_error.
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Ready for reading once one has come.
  [[nodiscard]] int fd() const { return fd_; }

 private:
  int fd_;
};

}  // namespace scarab::emulator
