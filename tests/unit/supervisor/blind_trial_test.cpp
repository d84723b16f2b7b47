#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>

#include "common/config/robot_file.hpp"
#include "services/plant/adapter.hpp"
#include "services/plant/config.hpp"
#include "services/plant/core/scene.hpp"
#include "services/plant/core/simulation.hpp"
#include "services/premotor/config.hpp"
#include "services/premotor/core/premotor_controller.hpp"
#include "services/supervisor/adapter.hpp"
#include "services/supervisor/config.hpp"

// Whole trials of a robot that does not measure its joints' angles: the plant, whose robot_state
// says for each joint what it was told, as the bridge to such a robot does.
namespace scarab::supervisor {
namespace {

constexpr const char* kConfig = SCARAB_SOURCE_DIR "/config/";
constexpr double kObstacleM = 0.10;
constexpr double kBlockedGapM = 0.01;  // between object and wall: it has hit it

/// How the trials of scarab-sim are perturbed.
scarab_Trial across(std::uint64_t seed) {
  scarab_Trial trial{};
  trial.goal = scarab_GOAL_ACROSS;
  trial.time_limit_s = 60;
  trial.obstacle_height_m = kObstacleM;
  trial.seed = seed;
  trial.perturb_position_m = 0.02;
  trial.perturb_yaw_rad = 0.0523599;
  trial.perturb_friction = 0.1;
  return trial;
}

struct Outcome {
  bool success = false;
  Trigger trigger = Trigger::kNone;
  std::optional<double> blocked_s;  ///< the object has hit the wall, by the ground truth
  std::optional<double> mode_2_s;
  std::string complaint;
};

/// What else the robot lacks.
enum class Lacks { kAngles, kEverything };

class BlindRobot {
 public:
  BlindRobot(std::uint64_t seed, Lacks lacks)
      : robot_(config::load_robot(std::string(kConfig) + "robot/beetle.yaml")),
        plant_(plant::load_config(std::string(kConfig) + "plant/beetle.yaml")),
        supervisor_(load_config(std::string(kConfig) + "supervisor/beetle.yaml")),
        simulation_(robot_, plant_, plant::to_trial_spec(across(seed))),
        machine_(supervisor_, find_strategy(supervisor_, "soft+hard")),
        machine_state_(machine_.initial_state()),
        controller_(premotor::load_config(std::string(kConfig) + "premotor/beetle.yaml"), robot_),
        network_(controller_.initial_state(seed, true)),
        told_rad_(plant::start_targets(plant_.start)),
        lacks_(lacks) {}

  Outcome run() {
    Outcome outcome;
    for (std::uint32_t tick = 0; simulation_.truth().verdict == plant::Verdict::kOpen; ++tick) {
      const Decision decision = machine_.step(machine_state_, to_perception(heard(tick)));
      look(decision, outcome);
      simulation_.advance(answer(decision), nullptr);
    }
    outcome.success = simulation_.truth().verdict == plant::Verdict::kSuccess;
    outcome.complaint = machine_.complaint(machine_state_);
    return outcome;
  }

 private:
  /// The state of the robot as it tells it.
  scarab_RobotState heard(std::uint32_t tick) {
    scarab_RobotState state{};
    state.header.tick = tick;
    plant::fill(state, simulation_.observe(), robot_);
    std::copy(told_rad_.begin(), told_rad_.end(), std::begin(state.position_rad));
    std::fill(std::begin(state.position_source), std::end(state.position_source),
              scarab_SOURCE_COMMANDED);
    if (lacks_ == Lacks::kEverything) {
      state.supply_current_source = scarab_SOURCE_ABSENT;
      std::fill(std::begin(state.foot_force_source), std::end(state.foot_force_source),
                scarab_SOURCE_ABSENT);
    }
    return state;
  }

  void look(const Decision& decision, Outcome& outcome) const {
    const double time_s = static_cast<double>(simulation_.time_ns()) * 1e-9;
    const auto truth = simulation_.truth();
    const double gap_m =
        truth.object.position_m[0] - plant_.object.diameter_m / 2 - truth.obstacle_x_m;
    if (gap_m < kBlockedGapM && !outcome.blocked_s) outcome.blocked_s = time_s;
    if (decision.state == State::kMode2 && !outcome.mode_2_s) outcome.mode_2_s = time_s;
    outcome.trigger = decision.trigger;
  }

  robot::JointVector answer(const Decision& decision) {
    premotor::MotorIntent intent;
    intent.inputs = decision.inputs;
    intent.backbone_rad = decision.backbone_rad;
    network_ = controller_.step(network_, intent);
    return told_rad_ = controller_.targets(network_, intent);
  }

  robot::RobotModel robot_;
  plant::PlantConfig plant_;
  SupervisorConfig supervisor_;
  plant::Simulation simulation_;
  BehaviourMachine machine_;
  MachineState machine_state_;
  premotor::PremotorController controller_;
  premotor::NetworkState network_;
  robot::JointVector told_rad_;
  Lacks lacks_;
};

/// The least number of heads in 20 throws that no fair coin shows in more than 5 of 100 rows: what
/// is reached less often may be chance.
constexpr int kMoreThanChance = 15;
constexpr int kTrials = 20;

TEST(BlindTrial, TheSupplyCurrentTakesTheObjectAcross) {
  int successes = 0;
  for (int seed = 1; seed <= kTrials; ++seed) {
    const Outcome outcome = BlindRobot(static_cast<std::uint64_t>(seed), Lacks::kAngles).run();
    EXPECT_EQ(outcome.trigger, Trigger::kSupplyCurrent);
    EXPECT_EQ(outcome.complaint, "");
    successes += outcome.success ? 1 : 0;
    if (!outcome.mode_2_s) continue;
    ASSERT_TRUE(outcome.blocked_s) << "seed " << seed << ": switched, and never was blocked";
    EXPECT_GT(*outcome.mode_2_s, *outcome.blocked_s)
        << "seed " << seed << ": switched before the object had hit the wall";
  }
  std::cout << successes << " of " << kTrials << " across " << kObstacleM
            << " m by the supply current\n";
  EXPECT_GE(successes, kMoreThanChance);
}

TEST(BlindTrial, WithoutAnySignalItPushesOnAndComplains) {
  const Outcome outcome = BlindRobot(1, Lacks::kEverything).run();
  EXPECT_EQ(outcome.trigger, Trigger::kNone);
  EXPECT_FALSE(outcome.mode_2_s);
  EXPECT_FALSE(outcome.success) << "soft pushing alone does not lift the object over this wall";
  EXPECT_NE(outcome.complaint, "");
}

}  // namespace
}  // namespace scarab::supervisor
