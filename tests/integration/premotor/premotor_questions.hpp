#pragma once

#include <array>
#include <cmath>

#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"

namespace scarab::test {

/// The premotor controller as tests talk to it.
struct Premotor {
  using Question = scarab_Behaviour;
  using Answer = scarab_JointCommand;
  static constexpr const char* kName = "premotor";
  static constexpr const char* kAsker = "supervisor";
  static constexpr std::array<const char*, 1> kReaders = {"plant"};
  static constexpr const char* kExpect = "plant=1,supervisor=1";
  static constexpr const auto& question() { return bus::kBehaviour; }
  static constexpr const auto& answer() { return bus::kJointCommand; }

  static scarab_Trial trial(std::uint32_t number) {
    scarab_Trial trial{};
    trial.header.trial = number;
    bus::assign(trial.strategy, "soft+hard");
    trial.seed = 5;
    trial.perturb_cpg_phase = true;
    return trial;
  }
  /// Inputs that move all the time: each answer depends on all questions before it.
  static scarab_Behaviour question_of(std::uint32_t trial, std::uint32_t tick) {
    scarab_Behaviour behaviour{};
    behaviour.header = {trial, tick, tick * 100'000'000LL, 0};
    behaviour.mode = scarab_MODE_SOFT_PUSH;
    for (std::size_t i = 0; i < 4; ++i) {
      behaviour.inputs[i] = std::sin(0.3 * tick + static_cast<double>(i));
    }
    behaviour.backbone_rad = 0.01 * tick;
    behaviour.state = scarab_BEHAVIOUR_MODE_1;
    return behaviour;
  }
};

}  // namespace scarab::test
