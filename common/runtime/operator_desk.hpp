#pragma once

#include <optional>
#include <string>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"

namespace scarab::runtime {

/// True for the commands of the tick master; the others are the supervisor's.
[[nodiscard]] bool is_for_tick_master(scarab_OperatorCommand command);

/// Takes in what a person says on scarab/operator and remembers what of it still holds.
class OperatorDesk {
 public:
  explicit OperatorDesk(bus::Participant& participant) : reader_(participant, bus::kOperator) {}

  /// What has been asked for once and is to be carried out now.
  struct Requests {
    std::optional<std::string> stop;            ///< end the trial, and why
    std::optional<std::string> emergency_stop;  ///< safe stop, and why
    bool reset = false;                         ///< leave the safe stop
  };
  Requests update();

  /// True while the next tick may not start.
  [[nodiscard]] bool paused() const { return paused_ && steps_ == 0; }
  /// A tick has started: uses up one step.
  void tick_started();
  void begin_trial();
  /// Stamp of the last command taken in, ns: its acknowledgement; 0 before the first.
  [[nodiscard]] std::int64_t stamp_ns() const { return stamp_ns_; }

  [[nodiscard]] bus::Reader<scarab_Operator>& reader() { return reader_; }

 private:
  bool counts(const scarab_Operator& said);

  bus::Reader<scarab_Operator> reader_;
  bool paused_ = false;
  unsigned steps_ = 0;
  std::int64_t stamp_ns_ = 0;
  std::int64_t emergency_stamp_ns_ = 0;
};

}  // namespace scarab::runtime
