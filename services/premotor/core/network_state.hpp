#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "common/robot/joints.hpp"

namespace scarab::premotor {

/// Outputs of all neurons after one update: the whole state of the network, enough to go on from
/// bit by bit. Mirrors scarab/neural_activity field by field. Trivially copyable: it is written to
/// disk as it is.
struct NetworkState {
  std::array<double, 4> input{};  ///< I1..I4
  std::array<double, 2> cpg{};    ///< C1, C2
  std::array<double, 14> psn1{};  ///< P1..P14
  std::array<double, 14> psn2{};
  std::array<double, 14> psn3{};
  std::array<double, 14> psn4{};
  std::array<double, 7> vrn1{};  ///< V1..V7
  std::array<double, 7> vrn2{};
  std::array<double, 8> delay_line{};  ///< D1..D8, of PSN3.P13; unused places are 0
  robot::JointVector motor{};          ///< motor neurons in joint slots, before gains and offsets
};

inline constexpr std::size_t kNeuronCount = 4 + 2 + 4 * 14 + 2 * 7 + 8 + robot::kJointCount;

static_assert(std::is_trivially_copyable_v<NetworkState>);
static_assert(sizeof(NetworkState) == kNeuronCount * sizeof(double),
              "no padding: doubles in a row");

}  // namespace scarab::premotor
