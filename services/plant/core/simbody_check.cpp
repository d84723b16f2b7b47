#include "services/plant/core/simbody_check.hpp"

#include <stdexcept>
#include <string>

namespace scarab::plant {
namespace {

constexpr double kTolerance = 1e-9;

/// A motion that is no longer finite is told of elsewhere: it is no difference.
template <class Found, class Expected>
void require_equal(const Found& found, const Expected& expected, const std::string& what) {
  const double difference = (found - expected).cwiseAbs().maxCoeff();
  if (difference > kTolerance * (1 + expected.cwiseAbs().maxCoeff())) {
    throw std::logic_error("the plant's " + what + " differs from Simbody's by " +
                           std::to_string(difference));
  }
}

}  // namespace

void SimbodyCheck::compare(const MotionState& state, const Kinematics& kinematics,
                           const SpeedMatrix& mass, const SpeedVector& inertial,
                           const SpeedVector& acceleration) {
  tree_.update(state, expected_);
  for (std::size_t i = 0; i < kBodyCount; ++i) {
    const BodyMotion& body = kinematics.body[i];
    const BodyMotion& expected = expected_.body[i];
    const std::string name = "body " + std::to_string(i);
    require_equal(body.R_world_body, expected.R_world_body, "orientation of " + name);
    require_equal(body.position, expected.position, "position of " + name);
    require_equal(body.angular_velocity, expected.angular_velocity, "angular velocity of " + name);
    require_equal(body.velocity, expected.velocity, "velocity of " + name);
  }
  SpeedVector expected_force;
  tree_.inverse_dynamics(acceleration, expected_force);
  const SpeedVector force = mass.selfadjointView<Eigen::Lower>() * acceleration + inertial;
  require_equal(force, expected_force, "inverse dynamics");
}

}  // namespace scarab::plant
