#include "services/experiment/config.hpp"

#include "common/config/config.hpp"
#include "common/config/json.hpp"
#include "common/runtime/trial_limits.hpp"
#include "services/experiment/row_writer.hpp"

namespace scarab::experiment {
namespace {

constexpr std::size_t kStrategyMost = 63;  // bound of Trial.strategy

config::Range within(const runtime::Limits& limits) { return {limits.low, limits.high}; }

}  // namespace

/// Written and read in this order.
template <class Fields>
void visit_fields(Fields& f, TrialLine& c) {
  f.optional("index", c.index);
  f("strategy", c.strategy);
  f("goal", c.goal);
  f("height_m", c.height_m, within(runtime::kHeightLimitsM));
  f("distance_m", c.distance_m, within(runtime::kDistanceLimitsM));
  f("time_limit_s", c.time_limit_s, within(runtime::kTimeLimitsS));
  f("seed", c.seed);
  f("perturb_position_m", c.perturb_position_m, within(runtime::kPerturbPositionLimitsM));
  f("perturb_yaw_rad", c.perturb_yaw_rad, within(runtime::kPerturbYawLimitsRad));
  f("perturb_friction", c.perturb_friction, within(runtime::kPerturbFrictionLimits));
  f("perturb_cpg_phase", c.perturb_cpg_phase);
  f("friction_scale", c.friction_scale, within(runtime::kFrictionScaleLimits));
  f("object_mass_kg", c.object_mass_kg, within(runtime::kObjectMassLimitsKg));
  f("object_diameter_m", c.object_diameter_m, within(runtime::kObjectDiameterLimitsM));
}

void validate(const TrialLine& c, const config::Check& check) {
  check.require(c.strategy.size() <= kStrategyMost, "strategy", "is longer than 63 bytes");
  check.require(c.goal != Goal::kAcross || c.height_m > 0, "goal",
                "across needs an obstacle: height_m greater than 0");
}

TrialLine read_trial_line(const std::string& name, const std::string& text) {
  return config::load_text<TrialLine>(name, text);
}

std::string result_row(const TrialLine& line, const Outcome& outcome) {
  TrialLine said = line;  // visit_fields() takes a mutable struct
  RowWriter row;
  visit_fields(row, said);
  row("success", outcome.success);
  row("time_s", outcome.end.time_s);
  row("reason", outcome.reason);
  const Measures& measures = outcome.measures;
  row("object_travel_m", measures.object_travel_m);
  row("object_sideways_m", measures.object_sideways_m);
  row("trunk_travel_m", measures.trunk_travel_m);
  row("heading_rad", measures.heading_rad);
  row("heading_max_rad", measures.heading_max_rad);
  row("climb_s", measures.climb_s);
  row("mode1_s", measures.mode1_s);
  row("mode2_s", measures.mode2_s);
  return row.text();
}

std::string error_row(std::optional<std::uint64_t> index, const std::string& error) {
  RowWriter row;
  row.optional("index", index);
  row("error", error);
  return row.text();
}

}  // namespace scarab::experiment
