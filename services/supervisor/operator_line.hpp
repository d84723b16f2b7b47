#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/status_publisher.hpp"
#include "services/supervisor/core/behaviour_machine.hpp"

namespace scarab::supervisor {

/// The operator's line to the behaviour machine. Its words count at the next tick of the trial they
/// are said in; each is acknowledged by its stamp, as counter operator_stamp_ns, once it is in the
/// state that survives a crash, with a message that says what holds or why the word is refused.
class OperatorLine {
 public:
  explicit OperatorLine(bus::Participant& participant) : reader_(participant, bus::kOperator) {}

  /// A new trial begins automatic: what was said before it is for nobody.
  void begin(std::uint32_t trial);
  /// Until the next trial words are refused.
  void end() { trial_ = 0; }

  /// Tells the machine what has been said since the last tick. `heard_ns`, the stamp of the last
  /// word heard, is kept with the state: its repetition is no new word.
  void tell(const BehaviourMachine& machine, MachineState& state, std::uint32_t tick,
            std::int64_t& heard_ns);

  /// This state is safe now: its last word is to be acknowledged.
  void acknowledge(const MachineState& state, std::int64_t heard_ns);

  /// Takes what has arrived, says what is to be acknowledged; refuses what is said while no trial
  /// runs.
  void report(runtime::StatusPublisher& status);

 private:
  void take();

  bus::Reader<scarab_Operator> reader_;
  std::vector<scarab_Operator> waiting_;  // for the next tick
  std::uint32_t trial_ = 0;               // 0: none runs
  std::string refused_;                   // the last word, and why; empty: it is taken
  std::int64_t acknowledged_ns_ = 0;
  bool changed_ = false;  // since the last report
  std::string message_;
};

}  // namespace scarab::supervisor
