#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/joints.hpp"

namespace scarab::drive {

enum class Concern { kNone, kWaits, kDegraded, kFault };

/// One service's last word of itself.
struct ServiceLine {
  std::string name;       ///< such as plant/0
  std::string lifecycle;  ///< such as active
  Concern concern = Concern::kNone;
  std::string message;
};

/// How well the tick master keeps time, s.
struct Timing {
  double jitter_p99_s = 0;
  double jitter_max_s = 0;
  double command_age_p99_s = 0;
  double command_age_max_s = 0;
};

/// All that is known of the running stack: what the view shows.
struct Live {
  std::string where;                 ///< such as "domain 0"
  std::string tick_master;           ///< such as plant/0; empty: none is there
  bool tick_master_answers = false;  ///< its status is alive
  std::string tick_master_says;
  bool trial_runs = false;
  bool safe_stop = false;  ///< latched, whether a trial runs or not

  // scarab/robot_state
  std::uint32_t trial = 0;  ///< 0: none heard of yet
  std::uint32_t tick = 0;
  double time_s = 0;  ///< simulated or real, since the start of the trial
  double ticks_per_s = 0;
  bool real_time = false;
  std::string phase;
  bool trial_over = false;  ///< that was its last tick
  robot::JointVector position_rad{};
  std::array<bool, robot::kJointCount> has_joint{};

  // scarab/behaviour
  std::string state;
  std::string reason;
  std::string mode;
  std::array<double, 4> inputs{};
  double bs_rad = 0;
  double bs_threshold_rad = 0;
  double as_rad = 0;
  double as_threshold_rad = 0;
  bool by_load = false;  ///< another signal than AS switches to mode 2: the one below
  std::string trigger;   ///< such as "supply current"
  std::string trigger_unit;
  double trigger_value = 0;
  double trigger_threshold = 0;

  // scarab/service_status
  std::vector<ServiceLine> services;
  std::vector<std::pair<std::string, std::uint64_t>> refused;  ///< commands, by why; none with 0
  Timing timing;
  std::uint64_t clamped = 0;
};

}  // namespace scarab::drive
