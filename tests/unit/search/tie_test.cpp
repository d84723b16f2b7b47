#include "tools/search/tie.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/support/programs.hpp"

namespace scarab::search {
namespace {

ConfigurationTree beetle() {
  return {
      {"robot/beetle.yaml", "plant/beetle.yaml", "premotor/beetle.yaml", "supervisor/beetle.yaml"},
      test::source_file("config")};
}

TEST(CpgPeriod, IsThatOfTheOrbit) {
  EXPECT_NEAR(cpg_period_ticks(1.4, 0.70), 14.43, 0.011);  // shared with the supervisor's AS
}

TEST(CpgPeriod, TendsToThatOfTheLinearRotationForAnOrbitNearTheOrigin) {
  const double angle = 0.3;
  const double period = cpg_period_ticks(1.001 * std::cos(angle), 1.001 * std::sin(angle));
  EXPECT_NEAR(period, 2 * M_PI / angle, 0.05);
}

TEST(CpgPeriod, IsShorterForAStrongerCoupling) {
  EXPECT_LT(cpg_period_ticks(1.4, 0.8), cpg_period_ticks(1.4, 0.6));
}

TEST(CpgPeriod, RefusesWhatDoesNotGoRound) {
  EXPECT_THROW((void)cpg_period_ticks(1.4, 0), std::invalid_argument);
}

TEST(Ties, FollowTheirSource) {
  ConfigurationTree tree = beetle();
  tree.set_number("premotor.motor.front.t_offset_rad", 0.123);
  tree.set_number("premotor.network.cpg.w12", 0.6);
  apply_ties(tree, {{"plant.start.front_rad.0", "premotor.motor.front.t_offset_rad"},
                    {"supervisor.as.window_ticks", "cpg_period_ticks"}});
  EXPECT_EQ(tree.number("plant.start.front_rad.0"), 0.123);
  EXPECT_EQ(tree.build().plant.start.front_rad[0], 0.123);
  EXPECT_EQ(tree.number("supervisor.as.window_ticks"),
            cpg_period_ticks(tree.number("premotor.network.cpg.w11"), 0.6));
}

TEST(Ties, AreRefusedWhereTheyCannotBe) {
  const ConfigurationTree tree = beetle();
  const std::string to = "plant.start.backbone_rad";
  const auto refusal = [&](Ties ties) { return refusal_of_tie(tree, ties, ties.begin()->first); };
  EXPECT_EQ(refusal({{to, "supervisor.backbone_rad"}}), "");
  EXPECT_NE(refusal({{to, "supervisor.backbone"}}), "");
  EXPECT_NE(refusal({{to, "no_such_function"}}), "");
  EXPECT_NE(refusal({{"plant.start.front_rad", "supervisor.backbone_rad"}}), "") << "a list";
  EXPECT_NE(refusal({{to, "plant.start.front_rad.0"},
                     {"plant.start.front_rad.0", "supervisor.backbone_rad"}}),
            "")
      << "a chain";
}

}  // namespace
}  // namespace scarab::search
