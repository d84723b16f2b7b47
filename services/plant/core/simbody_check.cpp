#include "services/plant/core/simbody_check.hpp"

#include <stdexcept>
#include <string>

namespace scarab::plant {
namespace {

constexpr double kTolerance = 1e-9;

/// A motion that is no longer finite is told of elsewhere: it is no difference.
template <class Found, class Expected>
bool differ(const Found& found, const Expected& expected) {
  const double difference = (found - expected).cwiseAbs().maxCoeff();
  return difference > kTolerance * (1 + expected.cwiseAbs().maxCoeff());
}

[[noreturn]] void report(const std::string& what) {
  throw std::logic_error("the plant's " + what + " differs from Simbody's");
}

}  // namespace

void SimbodyCheck::compare(const MotionState& state, const Kinematics& kinematics,
                           const SpeedMatrix& mass, const SpeedVector& inertial,
                           const SpeedVector& acceleration) {
  tree_.update(state, expected_);
  for (std::size_t i = 0; i < kBodyCount; ++i) {
    const BodyMotion& body = kinematics.body[i];
    const BodyMotion& expected = expected_.body[i];
    if (differ(body.R_world_body, expected.R_world_body) ||
        differ(body.position, expected.position)) {
      report("pose of body " + std::to_string(i));
    }
    if (differ(body.angular_velocity, expected.angular_velocity) ||
        differ(body.velocity, expected.velocity)) {
      report("velocity of body " + std::to_string(i));
    }
  }
  tree_.inverse_dynamics(acceleration, expected_force_);
  const SpeedVector force = mass.selfadjointView<Eigen::Lower>() * acceleration + inertial;
  if (differ(force, expected_force_)) report("inverse dynamics");
}

}  // namespace scarab::plant
