#include "tools/emulator/robot_thread.hpp"

#include <spdlog/spdlog.h>

#include "common/runtime/real_time_care.hpp"

namespace scarab::emulator {

RobotThread::RobotThread(Robot& robot, Mailbox<Orders>& orders, Mailbox<Report>& reports)
    : orders_(orders), thread_([this, &robot, &reports] { live(robot, reports); }) {}

void RobotThread::live(Robot& robot, Mailbox<Report>& reports) noexcept {
  try {
    const runtime::RealTimeCare care = runtime::take_real_time_care();
    if (!care.priority_raised) spdlog::warn("{}", care.priority_refusal);
    robot.run();
  } catch (...) {
    failure_ = std::current_exception();
  }
  reports.put([](Report& report) { report.ended = true; });
}

void RobotThread::end() {
  join();
  if (failure_) std::rethrow_exception(failure_);
}

void RobotThread::join() {
  if (!thread_.joinable()) return;
  orders_.put([](Orders& orders) { orders.end = true; });
  thread_.join();
}

}  // namespace scarab::emulator
