#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/waitset.hpp"
#include "common/bus/writer.hpp"
#include "common/runtime/options.hpp"
#include "common/runtime/shutdown.hpp"
#include "common/runtime/status_board.hpp"
#include "common/runtime/trial_options.hpp"
#include "tools/drive/keys.hpp"
#include "tools/drive/live.hpp"
#include "tools/drive/view.hpp"

namespace scarab::drive {

/// The running stack as a driver meets it: sees what it does, speaks on scarab/operator and
/// scarab/trial.
class Stack {
 public:
  explicit Stack(const runtime::BusOptions& options);

  /// Waits for news, at most `limit`, and takes in what came. False: SIGINT or SIGTERM came.
  bool wait(std::chrono::nanoseconds limit);
  [[nodiscard]] const Live& live() const { return live_; }

  /// Says it at once.
  void say(const Order& order);
  /// What became of the last order, once there is news of it.
  std::optional<Notice> news_of_order();
  [[nodiscard]] bool order_is_open() const { return open_.has_value(); }

  /// Who is missing before a trial can be told: its number must be above all of theirs. Empty:
  /// nobody.
  [[nodiscard]] std::string missing_for_trial() const;
  /// Tells a new trial; returns its number.
  std::uint32_t tell_trial(const runtime::TrialOptions& options);
  /// It was told just now, and everybody is getting ready.
  [[nodiscard]] bool trial_is_starting() const;
  /// The trial that runs is one that this program has told.
  [[nodiscard]] bool runs_own_trial() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct OpenOrder {
    Order order;
    std::int64_t stamp_ns;
    Clock::time_point since;
  };

  void measure_rate();
  [[nodiscard]] std::optional<bus::Peer> tick_master() const;
  [[nodiscard]] const runtime::ServiceReport* acknowledging() const;

  bus::Participant participant_;
  bus::Reader<scarab_RobotState> states_;
  bus::Reader<scarab_Behaviour> behaviours_;
  runtime::StatusBoard board_;
  bus::Writer<scarab_Operator> orders_;
  bus::Writer<scarab_Trial> trials_;
  bus::Guard guard_;
  bus::WaitSet wait_set_;
  runtime::Shutdown shutdown_;

  Live live_;
  std::optional<OpenOrder> open_;
  std::int64_t last_stamp_ns_ = 0;
  std::uint32_t own_trial_ = 0;
  Clock::time_point told_{};
  std::uint32_t rate_trial_ = 0;
  std::uint32_t rate_tick_ = 0;
  Clock::time_point rate_since_{};
};

}  // namespace scarab::drive
