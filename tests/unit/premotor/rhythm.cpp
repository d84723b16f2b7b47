#include "tests/unit/premotor/rhythm.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace scarab::premotor {
namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

const Action& action(const std::string& name) {
  for (const Action& row : kTable1) {
    if (row.name == name) {
      return row;
    }
  }
  throw std::invalid_argument("Table 1 has no row " + name);
}

Recording record(const PremotorController& controller, const MotorIntent& intent,
                 std::size_t ticks) {
  constexpr int kSettleTicks =
      60;  // a change of the inputs has passed all layers and the delay line after 20
  NetworkState state = controller.initial_state(0, false);
  for (int i = 0; i < kSettleTicks; ++i) {
    state = controller.step(state, intent);
  }
  Recording result;
  for (std::size_t i = 0; i < ticks; ++i) {
    state = controller.step(state, intent);
    result.states.push_back(state);
    result.targets.push_back(controller.targets(state, intent));
  }
  return result;
}

Signal signal(const Recording& recording, const std::function<double(const NetworkState&)>& pick) {
  Signal values;
  std::transform(recording.states.begin(), recording.states.end(), std::back_inserter(values),
                 pick);
  return values;
}

Signal target(const Recording& recording, robot::Leg leg, robot::LegJoint joint) {
  Signal values;
  for (const robot::JointVector& targets : recording.targets) {
    values.push_back(targets[joint_slot(leg, joint)]);
  }
  return values;
}

double turn_per_tick_rad(const std::vector<std::array<double, 2>>& orbit) {
  double turned = 0;
  for (std::size_t i = 1; i < orbit.size(); ++i) {
    turned +=
        wrap(std::atan2(orbit[i][1], orbit[i][0]) - std::atan2(orbit[i - 1][1], orbit[i - 1][0]));
  }
  return turned / static_cast<double>(orbit.size() - 1);
}

std::complex<double> component(const Signal& signal, double omega) {
  const double mean = mean_of(signal);
  const auto n = static_cast<double>(signal.size());
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const auto t = static_cast<double>(i);
    const double window = 1 - std::cos(2 * kPi * t / n);
    sum += window * (signal[i] - mean) * std::polar(1.0, -omega * t);
  }
  return 2.0 * sum / n;
}

double lag_rad(const Signal& signal, const Signal& reference, double omega) {
  return wrap(std::arg(component(reference, omega)) - std::arg(component(signal, omega)));
}

double wrap(double angle_rad) {
  const double wrapped = std::remainder(angle_rad, 2 * kPi);
  return wrapped <= -kPi ? wrapped + 2 * kPi : wrapped;
}

double min_of(const Signal& signal) { return *std::min_element(signal.begin(), signal.end()); }
double max_of(const Signal& signal) { return *std::max_element(signal.begin(), signal.end()); }
double swing_of(const Signal& signal) { return max_of(signal) - min_of(signal); }
double mean_of(const Signal& signal) {
  return std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
}

double walking_sense(const Signal& t, const Signal& c) {
  const double c_mean = mean_of(c);
  double covariance = 0;
  double t_square = 0;
  double c_square = 0;
  for (std::size_t i = 1; i + 1 < t.size(); ++i) {
    const double velocity = (t[i + 1] - t[i - 1]) / 2;
    covariance += velocity * (c[i] - c_mean);
    t_square += velocity * velocity;
    c_square += (c[i] - c_mean) * (c[i] - c_mean);
  }
  return covariance / std::sqrt(t_square * c_square);
}

}  // namespace scarab::premotor
