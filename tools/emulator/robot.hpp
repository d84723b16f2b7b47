#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "tools/emulator/boards/board.hpp"
#include "tools/emulator/configuration.hpp"
#include "tools/emulator/faults/effects.hpp"
#include "tools/emulator/faults/fault_plan.hpp"
#include "tools/emulator/letters.hpp"
#include "tools/emulator/mailbox.hpp"
#include "tools/emulator/wire/wire.hpp"
#include "tools/emulator/world/world.hpp"

namespace scarab::emulator {

/// The robot at the end of its wire: board, faults, world. It stands in for hardware, which answers
/// in time whatever else the computer does. So a thread of its own runs it, which waits for the
/// wire and for the clock and for nothing else: no bus, no file, no log; those are the
/// laboratory's, and both leave each other letters.
class Robot {
 public:
  /// Throws std::runtime_error if the device cannot be made. The mailboxes outlive it.
  Robot(const EmulatorOptions& options, const Configuration& configuration, Mailbox<Orders>& orders,
        Mailbox<Report>& reports);

  /// Until it is told to end. Throws std::runtime_error if a device that was plugged out cannot be
  /// plugged in again.
  void run();

  /// What it is and how fast, one phrase.
  [[nodiscard]] std::string description() const;

  /// Another world for a trial, which is built while this one goes on: this may be called by
  /// another thread while run() runs. Throws std::invalid_argument.
  [[nodiscard]] std::unique_ptr<plant::Simulation> build_world(const plant::TrialSpec& trial,
                                                               const Pose& pose) const;
  /// Once run() has returned.
  [[nodiscard]] const Lateness& lateness() const { return world_.lateness(); }

 private:
  [[nodiscard]] bool take_orders(std::int64_t now);  // false: it is to end
  void pass(std::int64_t now);
  void enter(std::uint32_t trial, std::unique_ptr<plant::Simulation> world);
  void update_faults(std::int64_t now);
  void move_world(std::int64_t now);
  void show_still_world(std::int64_t now);
  void note(std::string_view event, const std::string& detail);
  void show();
  void note_lateness(std::int64_t now);
  void send_report();
  void sleep();

  Mailbox<Orders>& orders_;
  Mailbox<Report>& reports_;
  Report report_;  // what has come up since the last one was sent
  std::unique_ptr<Board> board_;
  unsigned baud_;
  World world_;
  FaultPlan faults_;
  Effects effects_;
  Wire wire_;
  std::uint32_t trial_ = 0;      // of the world; 0: nobody has told one
  std::uint64_t power_ups_ = 0;  // when the world was built
  std::uint64_t noted_lateness_ = 0;
  std::int64_t next_note_ns_ = 0;
  std::int64_t next_show_ns_ = 0;
};

}  // namespace scarab::emulator
