#include "services/premotor/config.hpp"

#include "common/config/config.hpp"

namespace scarab::premotor {
namespace {

constexpr double kDelayMost = 8;        // places of the delay line
constexpr double kWarmupMost = 100000;  // ticks
constexpr config::Range kInputRange{-1, 1};
constexpr config::Range kBiasRange{-1, 1};  // of a signal within [-1, 1]

}  // namespace

template <class Fields>
void visit_fields(Fields& f, CpgConfig& c) {
  f("w11", c.w11);
  f("w12", c.w12);
  f("start_output", c.start_output, kInputRange);
}

template <class Fields>
void visit_fields(Fields& f, PsnConfig& c) {
  f("input_weight", c.input_weight);
  f("signal_weight", c.signal_weight);
  f("gate_weight", c.gate_weight);
  f("middle_weight", c.middle_weight);
  f("middle_bias", c.middle_bias);
  f("output_weight", c.output_weight);
  f("output_bias", c.output_bias);
}

template <class Fields>
void visit_fields(Fields& f, VrnConfig& c) {
  f("input_weight", c.input_weight);
  f("hidden_bias", c.hidden_bias);
  f("output_weight", c.output_weight);
}

template <class Fields>
void visit_fields(Fields& f, HindAmplitudeConfig& c) {
  f("c_i3_weight", c.c_i3_weight);
  f("c_bias", c.c_bias);
  f("t_i2_weight", c.t_i2_weight);
  f("t_bias", c.t_bias);
}

template <class Fields>
void visit_fields(Fields& f, MotorBiasConfig& c) {
  f("front_middle_t", c.front_middle_t, kBiasRange);
  f("front_middle_c", c.front_middle_c, kBiasRange);
  f("hind_t", c.hind_t, kBiasRange);
  f("hind_c", c.hind_c, kBiasRange);
}

template <class Fields>
void visit_fields(Fields& f, NetworkConfig& c) {
  f("cpg", c.cpg);
  f("psn", c.psn);
  f("vrn", c.vrn);
  f("hind_amplitude", c.hind_amplitude);
  f("motor_bias", c.motor_bias);
  f("t_delay_ticks", c.t_delay_ticks, config::Range{0, kDelayMost});
}

template <class Fields>
void visit_fields(Fields& f, MotorRowConfig& c) {
  f("t_offset_rad", c.t_offset_rad);
  f("t_gain_rad", c.t_gain_rad);
  f("c_offset_rad", c.c_offset_rad);
  f("c_gain_rad", c.c_gain_rad);
  f("c_floor", c.c_floor);
  f("c_i4_gain_rad", c.c_i4_gain_rad);
  f("f_offset_rad", c.f_offset_rad);
  f("f_i3_gain_rad", c.f_i3_gain_rad);
}

template <class Fields>
void visit_fields(Fields& f, MotorConfig& c) {
  f("front", c.front);
  f("middle", c.middle);
  f("hind", c.hind);
}

template <class Fields>
void visit_fields(Fields& f, StartConfig& c) {
  f("warmup_ticks", c.warmup_ticks, config::Range{0, kWarmupMost});
  f("warmup_inputs", c.warmup_inputs, kInputRange);
}

template <class Fields>
void visit_fields(Fields& f, PremotorConfig& c) {
  f("network", c.network);
  f("motor", c.motor);
  f("start", c.start);
}

PremotorConfig load_config(const std::filesystem::path& path) {
  return config::load<PremotorConfig>(path);
}

PremotorConfig load_config_text(const std::string& file, const std::string& text) {
  return config::load_text<PremotorConfig>(file, text);
}

std::string dump_config(const PremotorConfig& config) { return config::dump(config); }

std::string config_schema() { return config::schema<PremotorConfig>("Scarab: config/premotor"); }

}  // namespace scarab::premotor
