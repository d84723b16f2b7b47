#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/guarded_body.hpp"
#include "common/runtime/operator_desk.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/status_board.hpp"
#include "common/runtime/status_publisher.hpp"
#include "common/runtime/tick_body.hpp"
#include "common/runtime/tick_pacer.hpp"
#include "common/runtime/tick_timing.hpp"
#include "common/safety/command_gate.hpp"

namespace scarab::runtime {

/// Lockstep: the next tick starts when this one's command is there. Real time: it starts when its
/// time has come. A command has until the first sensor sample after its tick and is applied as soon
/// as it is there; one that comes later counts from the next tick on.
enum class Pace { kLockstep, kRealTime };

struct TickMasterOptions {
  Pace pace = Pace::kLockstep;
  std::chrono::nanoseconds tick_period{};
  unsigned samples_per_tick =
      1;  ///< robot_sensors and world_state per tick; bounds the lead over the logger
  /// Shows in service_status how the last trial ended (end_words.hpp): for a body whose verdict is
  /// on no topic.
  bool tells_end = false;
  std::chrono::seconds report_silence{1};
  std::chrono::seconds give_up{10};
};

/// The one clock of the chain: runs trials on a TickBody, publishing robot_state k, waiting for
/// joint_command k (through the command gate) and moving the body on.
class TickMaster {
 public:
  TickMaster(bus::Participant& participant, const ServiceOptions& service, const bus::Peer& self,
             const TickMasterOptions& options, TickBody& body, safety::CommandGate& gate);

  /// Serves trials until SIGINT or SIGTERM.
  void run();

 private:
  struct Interrupted {};  // thrown where a wait ends by a shutdown or a newer trial

  /// Where a trial stands; the lifecycle shown is another matter: a device may be lost in one.
  enum class Stage { kIdle, kStarting, kRunning };

  // The trial and its ticks.
  void run_trial();
  bool succeeds(const std::function<void()>& step);
  bool run_tick();
  void move_body();
  scarab_TrialPhase publish_state(bool between_ticks);
  void flush();
  void finish();
  void leave_trial();
  void fail_trial(const std::string& why);
  void end_trial();
  [[nodiscard]] scarab_Header header() const;
  [[nodiscard]] scarab_TrialPhase phase() const;

  // The body, its device and the gate.
  void idle();
  void look_after_body();
  void publish_idle_state();
  [[nodiscard]] std::vector<std::string> body_needs() const;
  void go_home();
  void observe(scarab_RobotState& state);
  void reset_if_asked();
  void rest();
  void show_lifecycle();
  void report_gate();

  // What is waited for, and what comes meanwhile.
  void await_start();
  [[nodiscard]] std::vector<std::string> unmet_needs() const;
  void hold_if_paused();
  void await_command();
  void await_command_until(TickPacer::TimePoint deadline);
  void await_until(TickPacer::TimePoint time);
  void await_logger();
  [[nodiscard]] std::optional<bus::Peer> logger_behind(std::uint32_t lead) const;
  [[nodiscard]] std::string who_is_silent() const;
  void wait(std::chrono::nanoseconds timeout);
  void take_trials();
  void take_operator();
  void take_commands();

  [[nodiscard]] bool real_time() const { return options_.pace == Pace::kRealTime; }
  [[nodiscard]] std::chrono::nanoseconds sample_period() const {
    return options_.tick_period / options_.samples_per_tick;
  }

  TickMasterOptions options_;
  bus::Peer self_;
  TickBody& body_;
  safety::CommandGate& gate_;
  GuardedBody guarded_;
  Expectation expect_;
  PeerCheck peers_;

  bus::Guard guard_;
  bus::WaitSet wait_set_;
  bus::Reader<scarab_Trial> trials_;
  bus::Reader<scarab_JointCommand> commands_;
  bus::Reader<scarab_Behaviour> behaviours_;
  StatusBoard board_;
  OperatorDesk desk_;
  bus::Writer<scarab_RobotState> states_;
  bus::Writer<scarab_RobotState> sensors_;
  std::vector<scarab_RobotState> between_ticks_;  // samples that wait for flush()
  StatusPublisher status_;
  Shutdown shutdown_;

  std::optional<scarab_Trial> pending_;  // newest trial told, not yet begun
  Stage stage_ = Stage::kIdle;
  std::uint32_t trial_ = 0;
  std::uint32_t tick_ = 0;
  bool answered_ = false;             // the command of tick_ has been accepted
  std::int64_t behaviour_tick_ = -1;  // newest seen of this trial: tells who is silent
  TickPacer pacer_;
  TickTiming timing_;
  TickPacer::TimePoint idle_due_{};  // the body's next idle()
  bool deadline_over_ = false;       // of tick_'s command; real time only
  bool moving_ = false;              // inside the body's advance()
  bool reset_asked_ = false;
  std::string reset_refusal_;  // why the last reset was refused; empty: it was not
  bool gate_holds_ = false;    // as last reported
};

}  // namespace scarab::runtime
