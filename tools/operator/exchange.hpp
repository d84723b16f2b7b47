#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stdexcept>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/status_board.hpp"
#include "tools/operator/order.hpp"

namespace scarab::operator_desk {

/// SIGINT or SIGTERM came before the order was through.
struct Interrupted {};

/// A participant that says one thing on scarab/operator and hears what becomes of it.
class Exchange {
 public:
  using Report = runtime::ServiceReport;

  explicit Exchange(const runtime::BusOptions& options);

  /// Who is to carry it out: the supervisor, or the tick master, which is who writes robot_state.
  /// Nothing after `limit`: nobody of that kind listens. Throws Interrupted, as all that wait.
  std::optional<bus::Peer> find_listener(bool tick_master, std::chrono::milliseconds limit);
  /// Its report, once there is one.
  std::optional<Report> await_report(const bus::Peer& peer, std::chrono::milliseconds limit);

  /// Says it, as of `trial`; stamped with the last time it is said.
  void say(const Order& order, std::uint32_t trial);
  /// Who has acknowledged what was said; nobody after `limit`, or once `gives_up()`.
  std::optional<bus::Peer> await_acknowledgement(const std::function<bool()>& gives_up,
                                                 std::chrono::milliseconds limit);
  /// Its report once that shows what `shows` asks for, or as it is after `limit`; nothing if it has
  /// gone.
  std::optional<Report> await_effect(const bus::Peer& peer,
                                     const std::function<bool(const Report&)>& shows,
                                     std::chrono::milliseconds limit);

  [[nodiscard]] const Report* report(const bus::Peer& peer) const { return board_.find(peer); }
  [[nodiscard]] std::optional<bus::Peer> tick_master() const;

 private:
  bool wait_until(const std::function<bool()>& condition, std::chrono::milliseconds limit);
  [[nodiscard]] const Report* acknowledging() const;

  bus::Participant participant_;
  bus::Writer<scarab_Operator> writer_;
  bus::Reader<scarab_RobotState> states_;
  runtime::StatusBoard board_;
  bus::Guard guard_;
  bus::WaitSet wait_set_;
  runtime::Shutdown shutdown_;
  std::int64_t stamp_ns_ = 0;
};

}  // namespace scarab::operator_desk
