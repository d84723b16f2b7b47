#include "services/plant/core/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/plant/rig.hpp"

namespace scarab::plant {
namespace {

using Eigen::Vector3d;

constexpr double kDt = 0.002;

Contact foot_on_ground(double depth) {
  Contact contact;
  contact.a = {Solid::kGround, 0, kWorldBody};
  contact.b = {Solid::kFoot, 2, leg_body(robot::Leg::kL2, LegSegment::kTibia)};
  contact.touch = {Vector3d::Zero(), Vector3d::UnitZ(), depth};
  contact.feature = feature(contact.a, contact.b, 0);
  return contact;
}

ContactForce evaluate(ContactLaw& law, double depth, const Vector3d& velocity) {
  law.begin_step();
  return law.evaluate(foot_on_ground(depth), velocity, 0, 0.09, kDt);
}

ContactLaw default_law() {
  const PlantConfig config = testing::default_config();
  return {config.contact, config.friction};
}

TEST(ContactLaw, RestingContactIsASpring) {
  ContactLaw law = default_law();
  const ContactForce force = evaluate(law, 0.001, Vector3d::Zero());
  EXPECT_NEAR(force_on_b(force, Vector3d::UnitZ(), Vector3d::Zero()).z(), 20, 1e-9);
}

TEST(ContactLaw, NeverPulls) {
  ContactLaw law = default_law();
  const Vector3d leaving(0, 0, 1);
  EXPECT_EQ(force_on_b(evaluate(law, 0.001, leaving), Vector3d::UnitZ(), leaving).norm(), 0);
}

TEST(ContactLaw, FrictionIsCoulombsBeyondTheSlipSpeedAndLinearBelow) {
  ContactLaw law = default_law();
  const double limit = 1.2 * 20;
  for (const double speed : {0.0005, 0.001, 0.002, 0.01, 1.0}) {
    const Vector3d slip(0.6 * speed, -0.8 * speed, 0);
    const Vector3d force = force_on_b(evaluate(law, 0.001, slip), Vector3d::UnitZ(), slip);
    EXPECT_NEAR(force.head<2>().norm(), limit * std::min(1.0, speed / 0.002), 1e-9);
    EXPECT_NEAR(force.x() * slip.y(), force.y() * slip.x(), 1e-9) << "against the slip";
    EXPECT_LT(force.dot(slip), 0);
  }
}

/// Drift over ten seconds of 1 kg on a foot that sinks 0.5 mm, pulled with half of what friction
/// holds.
double creep(double anchor_stiffness_n_m) {
  PlantConfig config = testing::default_config();
  config.contact.anchor_stiffness_n_m = anchor_stiffness_n_m;
  ContactLaw law(config.contact, config.friction);
  const double pull = 0.5 * 1.2 * 10, mass = 1;
  double speed = 0, way = 0, after_one_second = 0;
  for (int i = 0; i < 5500; ++i) {
    const ContactForce force = evaluate(law, 0.0005, Vector3d(speed, 0, 0));
    speed += kDt * (pull + force.anchor_n.x() - force.slip_damping * speed) /
             (mass + kDt * force.slip_damping + kDt * kDt * anchor_stiffness_n_m);
    way += kDt * speed;
    if (i == 500) after_one_second = way;
  }
  return way - after_one_second;
}

TEST(ContactLaw, AnchorsHoldWhereRegularisedFrictionCreeps) {
  EXPECT_NEAR(creep(0), 10 * 0.5 * 0.002, 1e-3);
  EXPECT_LT(std::abs(creep(2e4)), 1e-4);
}

TEST(ContactLaw, AnchorsGiveWayAtTheCoulombLimit) {
  PlantConfig config = testing::default_config();
  config.contact.anchor_stiffness_n_m = 2e4;
  ContactLaw law(config.contact, config.friction);
  const Vector3d slip(0.1, 0, 0);
  ContactForce force;
  for (int i = 0; i < 200; ++i) force = evaluate(law, 0.001, slip);
  EXPECT_NEAR(force_on_b(force, Vector3d::UnitZ(), slip).x(), -1.2 * 20, 1e-6);
}

TEST(ContactLaw, AnchorsForgetAnOpenedContact) {
  PlantConfig config = testing::default_config();
  config.contact.anchor_stiffness_n_m = 2e4;
  ContactLaw law(config.contact, config.friction);
  evaluate(law, 0.001, Vector3d(0.1, 0, 0));
  law.begin_step();  // a step without this contact
  EXPECT_EQ(evaluate(law, 0.001, Vector3d::Zero()).anchor_n.norm(), 0);
}

TEST(FrictionCoefficient, DependsOnThePair) {
  const FrictionConfig friction{1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(friction_coefficient(friction, Solid::kGround, Solid::kFoot), 1);
  EXPECT_EQ(friction_coefficient(friction, Solid::kGround, Solid::kTibia), 1);
  EXPECT_EQ(friction_coefficient(friction, Solid::kGround, Solid::kFemur), 2);
  EXPECT_EQ(friction_coefficient(friction, Solid::kGround, Solid::kTrunk), 2);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObject, Solid::kFoot), 3);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObject, Solid::kTibia), 3);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObject, Solid::kCoxa), 4);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObject, Solid::kTrunk), 4);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObstacle, Solid::kFoot), 5);
  EXPECT_EQ(friction_coefficient(friction, Solid::kFemur, Solid::kTibia), 6);
  EXPECT_EQ(friction_coefficient(friction, Solid::kGround, Solid::kObject), 7);
  EXPECT_EQ(friction_coefficient(friction, Solid::kObject, Solid::kObstacle), 8);
}

}  // namespace
}  // namespace scarab::plant
