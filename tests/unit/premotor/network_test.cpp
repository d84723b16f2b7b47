#include "services/premotor/core/network.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace scarab::premotor {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The four inputs, to which the tests add what they need.
NetworkDescription inputs_only() {
  NetworkDescription description;
  for (const char* name : {"I1", "I2", "I3", "I4"}) {
    description.add_input(name);
  }
  return description;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Network, OneSynapseTakesOneStep) {
  NetworkDescription description = inputs_only();
  const NeuronId a = description.add_neuron("A", Transfer::kLinear);
  const NeuronId b = description.add_neuron("B", Transfer::kLinear);
  description.connect(description.find("I1"), a, 2);
  description.connect(a, b, 3);
  const Network network(std::move(description));

  Eigen::VectorXd output = Eigen::VectorXd::Zero(6);
  output = network.step(output, {1, 0, 0, 0});
  EXPECT_EQ(output, (Eigen::VectorXd(6) << 1, 0, 0, 0, 0, 0).finished());
  output = network.step(output, {0, 0, 0, 0});
  EXPECT_EQ(output, (Eigen::VectorXd(6) << 0, 0, 0, 0, 2, 0).finished());
  output = network.step(output, {0, 0, 0, 0});
  EXPECT_EQ(output, (Eigen::VectorXd(6) << 0, 0, 0, 0, 0, 6).finished());
}

TEST(Network, UpdatesAllNeuronsAtOnce) {
  NetworkDescription description = inputs_only();
  const NeuronId a = description.add_neuron("A", Transfer::kLinear);
  const NeuronId b = description.add_neuron("B", Transfer::kLinear);
  description.connect(a, b, 1);
  description.connect(b, a, 1);
  const Network network(std::move(description));
  const Eigen::VectorXd before = (Eigen::VectorXd(6) << 0, 0, 0, 0, 0.25, -0.5).finished();
  const Eigen::VectorXd after = (Eigen::VectorXd(6) << 0, 0, 0, 0, -0.5, 0.25).finished();
  EXPECT_EQ(network.step(before, {}), after) << "the two outputs change places";
}

TEST(Network, SumsSynapsesAndBiasBeforeTheTransferFunction) {
  NetworkDescription description = inputs_only();
  const NeuronId a = description.add_neuron("A", Transfer::kTanh, 0.1);
  description.connect(description.find("I1"), a, 0.5);
  description.connect(description.find("I2"), a, -0.25);
  description.connect(a, a, 0.75);
  const Network network(std::move(description));
  const Eigen::VectorXd before = (Eigen::VectorXd(5) << 0.4, 0.8, 0, 0, 0.2).finished();
  EXPECT_DOUBLE_EQ(network.step(before, {})[4], std::tanh(0.1 + 0.2 - 0.2 + 0.15));
}

TEST(Network, EvaluatesModulatorySynapsesAndDrivenBiasesAtEachStepFromTheInputNeurons) {
  NetworkDescription description = inputs_only();
  const NeuronId source = description.add_neuron("SOURCE", Transfer::kLinear, 1);
  const NeuronId target = description.add_neuron("TARGET", Transfer::kLinear);
  description.connect(source, target, [](const Inputs& i) { return 10 * i[0] * i[1]; });
  description.add_bias(target, [](const Inputs& i) { return 100 * i[3]; });
  const Network network(std::move(description));
  Eigen::VectorXd output = Eigen::VectorXd::Zero(6);
  output = network.step(output, {2, 3, 0, 0.5});  // the inputs' outputs are still 0
  EXPECT_EQ(output[5], 0);
  output = network.step(output, {1, 1, 0, 0});
  EXPECT_EQ(output[5], 10 * 2 * 3 + 100 * 0.5);
  output = network.step(output, {});
  EXPECT_EQ(output[5], 10);
}

TEST(NetworkDescription, RefusesWhatIsNotFiniteAndSaysWhere) {
  NetworkDescription description = inputs_only();
  const NeuronId a = description.add_neuron("A", Transfer::kTanh);
  EXPECT_THAT(message_of([&] { description.connect(0, a, kNan); }),
              testing::HasSubstr("I1 -> A: weight is not finite"));
  EXPECT_THAT(message_of([&] { description.add_neuron("B", Transfer::kTanh, HUGE_VAL); }),
              testing::HasSubstr("B: bias is not finite"));
}

TEST(NetworkDescription, RefusesNamesUsedTwiceAndNeuronsThatAreNotThere) {
  NetworkDescription description = inputs_only();
  EXPECT_THAT(message_of([&] { description.add_neuron("I1", Transfer::kTanh); }),
              testing::HasSubstr("I1"));
  EXPECT_THAT(message_of([&] { (void)description.find("PSN9.P1"); }),
              testing::HasSubstr("PSN9.P1"));
  EXPECT_THAT(message_of([&] { description.connect(0, 99, 1); }), testing::HasSubstr("99"));
  EXPECT_THAT(message_of([&] { description.add_input("I5"); }), testing::HasSubstr("at most 4"));
}

TEST(Network, NeedsAllFourInputs) {
  EXPECT_THROW(Network{NetworkDescription{}}, std::invalid_argument);
}

}  // namespace
}  // namespace scarab::premotor
