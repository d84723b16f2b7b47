#pragma once

#include <exception>
#include <thread>

#include "tools/emulator/letters.hpp"
#include "tools/emulator/mailbox.hpp"
#include "tools/emulator/robot.hpp"

namespace scarab::emulator {

/// The robot on a thread of its own, before all ordinary ones where the system grants that. It ends
/// with the object.
class RobotThread {
 public:
  /// All three outlive it.
  RobotThread(Robot& robot, Mailbox<Orders>& orders, Mailbox<Report>& reports);
  ~RobotThread() { join(); }
  RobotThread(const RobotThread&) = delete;
  RobotThread& operator=(const RobotThread&) = delete;

  /// Tells it to end and waits until it has. Rethrows what has ended it before its time.
  void end();

 private:
  void live(Robot& robot, Mailbox<Report>& reports) noexcept;
  void join();

  Mailbox<Orders>& orders_;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace scarab::emulator
