#include "services/plant/core/servo.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace scarab::plant {
namespace {

robot::Joint joint() {
  robot::Joint out;
  out.min_rad = -1;
  out.max_rad = 1;
  out.velocity_max_rad_s = 10;
  out.torque_max_nm = 5;
  out.kp_nm_rad = 10;
  out.kd_nm_s_rad = 0.8;
  return out;
}

/// A rotor of inertia `inertia` behind the servo, stepped as the stepper does.
double angle_after(const robot::Joint& servo, double inertia, double target, double duration,
                   double dt) {
  double angle = 0, speed = 0;
  for (long i = 0; i < std::lround(duration / dt); ++i) {
    const JointTorque torque = servo_torque(servo, target, angle, speed, dt);
    speed += dt * (torque.torque_nm - torque.damping_nm_s_rad * speed) /
             (inertia + dt * torque.damping_nm_s_rad);
    angle += dt * speed;
  }
  return angle;
}

TEST(Servo, StepResponseIsThatOfADampedOscillator) {
  const double inertia = 0.03, target = 0.2;  // under-damped, below the torque limit
  const double omega0 = std::sqrt(10 / inertia), decay = 0.8 / (2 * inertia);
  const double omega = std::sqrt(omega0 * omega0 - decay * decay);
  for (const double t : {0.05, 0.1, 0.2, 0.4}) {
    const double expected =
        target *
        (1 - std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t)));
    EXPECT_NEAR(angle_after(joint(), inertia, target, t, 1e-4), expected, 0.01 * target);
    EXPECT_NEAR(angle_after(joint(), inertia, target, t, 2e-3), expected, 0.05 * target);
  }
}

TEST(Servo, IsStableAtAnyStep) {
  robot::Joint stiff = joint();
  stiff.kp_nm_rad = 1e4;
  stiff.torque_max_nm = 1e9;
  for (const double dt : {1e-3, 1e-2, 1e-1}) {
    EXPECT_NEAR(angle_after(stiff, 1e-4, 0.2, 100 * dt, dt), 0.2, 1e-3) << dt;
  }
}

TEST(Servo, NeverExceedsItsTorque) {
  for (const double error : {-3.0, -0.6, 0.6, 3.0}) {
    const JointTorque torque = servo_torque(joint(), error, 0, 0, 0.002);
    EXPECT_EQ(torque.torque_nm, std::copysign(5.0, error));
    EXPECT_EQ(torque.damping_nm_s_rad, 0);
  }
  EXPECT_LT(std::abs(servo_torque(joint(), 0.4, 0, 0, 0.002).torque_nm), 5);
}

TEST(Servo, ReferenceSlewsAtTheJointsSpeed) {
  double reference = 0;
  for (int i = 0; i < 10; ++i) reference = slew(joint(), reference, 0.5, 0.002);
  EXPECT_NEAR(reference, 0.2, 1e-12);
  for (int i = 0; i < 100; ++i) reference = slew(joint(), reference, 0.5, 0.002);
  EXPECT_EQ(reference, 0.5);
}

TEST(JointStop, PushesBackOnlyBeyondTheRange) {
  const JointStopConfig stop{200, 2};
  EXPECT_EQ(stop_torque(stop, joint(), 0.99, 5, 0.002).torque_nm, 0);
  EXPECT_NEAR(stop_torque(stop, joint(), 1.01, 0, 0.002).torque_nm, -2, 1e-9);
  EXPECT_NEAR(stop_torque(stop, joint(), -1.01, 0, 0.002).torque_nm, 2, 1e-9);
  EXPECT_EQ(stop_torque(stop, joint(), 1.01, -5, 0.002).torque_nm, 0) << "it must not hold back";
}

}  // namespace
}  // namespace scarab::plant
