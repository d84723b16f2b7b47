#include "services/premotor/core/vrn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "services/premotor/core/network.hpp"
#include "tests/unit/premotor/f2_config.hpp"
#include "tests/unit/premotor/rhythm.hpp"

namespace scarab::premotor {
namespace {

/// A VRN whose V1 and V2 outputs are held at the given values: what it settles to is V3..V7.
double multiply(double v1, double v2) {
  NetworkDescription description;
  for (const char* name : {"I1", "I2", "I3", "I4"}) {
    description.add_input(name);
  }
  const VrnNeurons vrn = add_vrn(description, "VRN", f2_config().network.vrn, 0);
  description.connect(0, vrn.v1, 1);
  description.connect(1, vrn.v2, 1);
  const Network network(std::move(description));
  Eigen::VectorXd output = Eigen::VectorXd::Zero(11);
  for (int i = 0; i < 4; ++i) {
    output = network.step(output, {std::atanh(v1), std::atanh(v2), 0, 0});
  }
  EXPECT_NEAR(output[static_cast<Eigen::Index>(vrn.v1)], v1, 1e-12);
  EXPECT_NEAR(output[static_cast<Eigen::Index>(vrn.v2)], v2, 1e-12);
  return output[static_cast<Eigen::Index>(vrn.v7)];
}

TEST(Vrn, MultipliesWithinTheKnownBound) {
  double worst = 0;
  double worst_argument = 0;
  for (double x = -0.99; x < 1; x += 0.045) {
    for (double y = -0.99; y < 1; y += 0.045) {
      const double v7 = multiply(x, y);
      worst = std::max(worst, std::abs(v7 - x * y));
      worst_argument = std::max(worst_argument, std::abs(std::atanh(v7) - x * y));
    }
  }
  EXPECT_LE(worst_argument, 0.14);
  EXPECT_LE(worst, 0.30);
  EXPECT_GE(worst, 0.15) << "the last tanh is there: it compresses products near 1";
}

TEST(Vrn, HasTheSymmetriesOfAProduct) {
  for (const double x : {0.1, 0.4, 0.9}) {
    for (const double y : {0.2, 0.7}) {
      const double product = multiply(x, y);
      EXPECT_GT(product, 0);
      EXPECT_NEAR(multiply(y, x), product, 1e-12);
      EXPECT_NEAR(multiply(-x, y), -product, 1e-12);
      EXPECT_NEAR(multiply(-x, -y), product, 1e-12);
    }
    EXPECT_NEAR(multiply(x, 0), 0, 1e-12);
  }
}

TEST(Vrn, GrowsWithItsAmplitude) {
  double last = 0;
  for (double amplitude = 0.1; amplitude < 1; amplitude += 0.1) {
    const double v7 = multiply(amplitude, 0.6);
    EXPECT_GT(v7, last);
    last = v7;
  }
}

// Paper, section 2.3, in words: w9 = 2, w10 = 0, b3 = 0.02 for all actions but soft pushing, where
// they are 0, 1, 0.
TEST(Vrn, ChoosesCpgOrPsnAsThePaperSays) {
  for (const Action& row : kTable1) {
    const bool soft = std::string(row.name) == "soft_push";
    EXPECT_DOUBLE_EQ(vrn1_w9(row.inputs), soft ? 0 : 2) << row.name;
    EXPECT_DOUBLE_EQ(vrn1_w10(row.inputs), soft ? 1 : 0) << row.name;
    EXPECT_DOUBLE_EQ(vrn1_b3(row.inputs), soft ? 0 : 0.02) << row.name;
  }
}

}  // namespace
}  // namespace scarab::premotor
