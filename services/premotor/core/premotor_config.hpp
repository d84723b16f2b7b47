#pragma once

#include <array>

/// Parameters of the premotor controller: pure data, filled from config/premotor/*.yaml. Weights
/// and biases are without unit; docs/equations.md has the equations they stand in, and says which
/// are reconstructions [R].
namespace scarab::premotor {

/// SO(2) oscillator: w11 = w22, w12 = -w21, no biases (Pasemann, Hild, Zahedi 2003).
struct CpgConfig {
  double w11 = 0;
  double w12 = 0;
  std::array<double, 2> start_output{};  ///< C1, C2 before the warm-up
};

/// Phase switching network: the weights its four modules share (paper, Fig. 3; Manoonpong et al.
/// 2008).
struct PsnConfig {
  double input_weight = 0;   ///< magnitude of the synapses into P1 and P2
  double signal_weight = 0;  ///< P1, P2 -> P5..P8
  double gate_weight = 0;    ///< P3, P4 -> P5..P8
  double middle_weight = 0;  ///< P5..P8 -> P9..P12
  double middle_bias = 0;    ///< of P9..P12
  double output_weight = 0;  ///< P9..P12 -> P13, P14
  double output_bias = 0;    ///< of P13, P14
};

/// Velocity regulating network: the weights its two modules share (paper, Fig. 4).
struct VrnConfig {
  double input_weight = 0;   ///< magnitude of V1, V2 -> V3..V6
  double hidden_bias = 0;    ///< b4, of V3..V6
  double output_weight = 0;  ///< magnitude of V3..V6 -> V7
};

/// How I3 and I2 set the amplitude of the hind legs' joints: neurons V1 of VRN1 and VRN2 (paper,
/// section 2.3).
struct HindAmplitudeConfig {
  double c_i3_weight = 0;  ///< I3 -> VRN1.V1
  double c_bias = 0;       ///< of VRN1.V1
  double t_i2_weight = 0;  ///< I2 -> VRN2.V1
  double t_bias = 0;       ///< of VRN2.V1
};

/// Biases of the T- and C-motor neurons of the tripod {L0, R1, L2}; those of {R0, L1, R2} have the
/// other sign, as their synapses do. The signals have a mean (of PSN3 and PSN4 0.034: the published
/// output bias), which the tripod's sign turns into offsets that differ between left and right, and
/// the robot walks in a circle; the biases balance that [R].
struct MotorBiasConfig {
  double front_middle_t = 0;
  double front_middle_c = 0;
  double hind_t = 0;
  double hind_c = 0;
};

struct NetworkConfig {
  CpgConfig cpg;
  PsnConfig psn;
  VrnConfig vrn;
  HindAmplitudeConfig hind_amplitude;
  MotorBiasConfig motor_bias;
  double t_delay_ticks =
      0;  ///< tau of the front and middle T-joints, 0..8; between two ticks: interpolated [R]
};

/// Motor neurons of one row of legs -> joint targets; docs/equations.md, "Joint targets".
struct MotorRowConfig {
  double t_offset_rad = 0;
  double t_gain_rad = 0;  ///< rad per unit of the motor neuron's output
  double c_offset_rad = 0;
  double c_gain_rad = 0;  ///< rad per unit
  double c_floor =
      0;  ///< the C motor neuron's output is clipped to at least this: stance stays on the ground
  double c_i4_gain_rad = 0;  ///< shift of the C offset, rad per unit of I4
  double f_offset_rad = 0;
  double f_i3_gain_rad = 0;  ///< shift of the F offset, rad per unit of I3
};

struct MotorConfig {
  MotorRowConfig front;
  MotorRowConfig middle;
  MotorRowConfig hind;
};

/// How a trial begins.
struct StartConfig {
  unsigned warmup_ticks = 0;              ///< the network runs so long before tick 0
  std::array<double, 4> warmup_inputs{};  ///< I1..I4 during it
};

struct PremotorConfig {
  NetworkConfig network;
  MotorConfig motor;
  StartConfig start;
};

}  // namespace scarab::premotor
