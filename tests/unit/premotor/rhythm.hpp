#pragma once

#include <complex>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "common/robot/joints.hpp"
#include "services/premotor/core/premotor_controller.hpp"

/// Runs of the network and what can be said of their rhythm.
namespace scarab::premotor {

using Signal = std::vector<double>;

/// A row of the paper's Table 1.
struct Action {
  const char* name;
  Inputs inputs;
};
inline void PrintTo(const Action& action, std::ostream* out) { *out << action.name; }
inline constexpr std::array<Action, 5> kTable1 = {{{"forward", {1, 1, 0, 0}},
                                                   {"backward", {0, 1, 0, 0}},
                                                   {"soft_push", {1, -1, 1, 1}},
                                                   {"boxing", {-1, -1, 1, 0}},
                                                   {"hard_push", {1, 0, 0, -0.3}}}};
/// The row of that name.
const Action& action(const std::string& name);

/// A settled run: the network's states and the joint targets, tick by tick.
struct Recording {
  std::vector<NetworkState> states;
  std::vector<robot::JointVector> targets;
};
Recording record(const PremotorController& controller, const MotorIntent& intent,
                 std::size_t ticks = 600);

/// A signal picked out of a run.
Signal signal(const Recording& recording, const std::function<double(const NetworkState&)>& pick);
Signal target(const Recording& recording, robot::Leg leg, robot::LegJoint joint);

/// Radians that (C1, C2) turns by in a tick, on average; the sign tells the sense.
double turn_per_tick_rad(const std::vector<std::array<double, 2>>& orbit);

/// Component of a signal at `omega` rad a tick: its amplitude and phase (Hann window).
std::complex<double> component(const Signal& signal, double omega);

/// Phase by which `signal` is behind `reference` at `omega`, in (-pi, pi].
double lag_rad(const Signal& signal, const Signal& reference, double omega);

/// Brings an angle into (-pi, pi].
double wrap(double angle_rad);

double min_of(const Signal& signal);
double max_of(const Signal& signal);
double swing_of(const Signal& signal);  ///< max - min
double mean_of(const Signal& signal);

/// > 0 if the leg swings forward while lifted (walks forward), < 0 if backward: covariance of the
/// T-joint's velocity with the C-joint's lift, over the product of their spreads.
double walking_sense(const Signal& t, const Signal& c);

}  // namespace scarab::premotor
