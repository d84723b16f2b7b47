#pragma once

#include <functional>
#include <optional>
#include <string>

#include "common/bus/topics.hpp"
#include "common/robot/joints.hpp"
#include "common/runtime/peers.hpp"

namespace scarab::runtime {

/// How a trial ended.
struct TrialEnd {
  bool success = false;
  std::string reason;
};

/// What the tick master moves: the simulated plant, or a real robot behind its bridge.
class TickBody {
 public:
  virtual ~TickBody() = default;

  /// Makes ready for a trial and stands still. Throws std::exception naming what of the trial
  /// cannot be done.
  virtual void begin(const scarab_Trial& trial) = 0;
  /// Time since the start of the trial, ns.
  [[nodiscard]] virtual std::int64_t time_ns() const = 0;
  /// What the robot's sensors read now; fills all but header and phase.
  virtual void observe(scarab_RobotState& state) const = 0;
  /// Joint targets that the robot holds before the first command, rad.
  [[nodiscard]] virtual robot::JointVector held_rad() const = 0;
  /// Moves for one control tick towards `target_rad`; calls `sample` after each sensor period
  /// inside it.
  virtual void advance(const robot::JointVector& target_rad,
                       const std::function<void()>& sample) = 0;
  /// The referee's verdict on the trial; none while it is open, none ever where there is no
  /// referee.
  [[nodiscard]] virtual std::optional<TrialEnd> verdict() const = 0;
  /// Ends the trial from outside (operator, silence): the verdict from now on.
  virtual void end(const TrialEnd& end) = 0;
  /// Publishes what the body alone knows (the plant: world_state), at every tick and every sample;
  /// may wait for flush_own().
  virtual void publish_own(const scarab_Header& header) = 0;
  /// Sends what publish_own() has kept back.
  virtual void flush_own() = 0;
  /// Names the peers its own writers need before a trial starts.
  virtual void add_needs(PeerCheck& peers) const = 0;
};

}  // namespace scarab::runtime
