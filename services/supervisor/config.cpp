#include "services/supervisor/config.hpp"

#include "common/config/config.hpp"
#include "services/supervisor/core/machine_state.hpp"

namespace scarab::supervisor {
namespace {

constexpr double kTicksMost = 100000;
constexpr config::Range kInputRange{-1, 1};
constexpr config::Range kCount{1, kTicksMost};

}  // namespace

inline auto enum_names(Mode) {
  std::array<std::pair<std::string_view, Mode>, kModeNames.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = {kModeNames[i], static_cast<Mode>(i)};
  return names;
}

inline auto enum_names(Trigger) {
  using Name = std::pair<std::string_view, Trigger>;
  return std::array<Name, 3>{Name{name(Trigger::kFrontAngle), Trigger::kFrontAngle},
                             Name{name(Trigger::kSupplyCurrent), Trigger::kSupplyCurrent},
                             Name{name(Trigger::kFootForce), Trigger::kFootForce}};
}

template <class Fields>
void visit_fields(Fields& f, InclinationConfig& c) {
  f("smoothing", c.smoothing, config::Range{0, 1, true});
  f("threshold_rad", c.threshold_rad);
  f("settle_ticks", c.settle_ticks, config::Range{2, kTicksMost});
}

template <class Fields>
void visit_fields(Fields& f, FrontAngleConfig& c) {
  f("window_ticks", c.window_ticks, config::Range{1, static_cast<double>(kMaxWindowTicks)});
  f("reference_rad", c.reference_rad);
  f("drop_rad", c.drop_rad, config::kNonNegative);
  f("confirm_ticks", c.confirm_ticks, kCount);
  f("arm_ticks", c.arm_ticks, config::Range{0, kTicksMost});
}

template <class Fields>
void visit_fields(Fields& f, SupplyCurrentConfig& c) {
  f("reference_a", c.reference_a, config::kNonNegative);
  f("rise_a", c.rise_a, config::kNonNegative);
  f("confirm_ticks", c.confirm_ticks, kCount);
  f("arm_ticks", c.arm_ticks, config::Range{0, kTicksMost});
}

template <class Fields>
void visit_fields(Fields& f, FootForceConfig& c) {
  f("reference_n", c.reference_n, config::kNonNegative);
  f("rise_n", c.rise_n, config::kNonNegative);
  f("confirm_ticks", c.confirm_ticks, kCount);
  f("arm_ticks", c.arm_ticks, config::Range{0, kTicksMost});
}

template <class Fields>
void visit_fields(Fields& f, ModeInputs& c) {
  f("stop", c.stop, kInputRange);
  f("forward", c.forward, kInputRange);
  f("backward", c.backward, kInputRange);
  f("soft_push", c.soft_push, kInputRange);
  f("boxing", c.boxing, kInputRange);
  f("stationary", c.stationary, kInputRange);
  f("hard_push", c.hard_push, kInputRange);
}

template <class Fields>
void visit_fields(Fields& f, Strategy& c) {
  f("approach", c.approach);
  f("push", c.push);
  f.optional("obstacle", c.obstacle);
}

void validate(const Strategy& c, const config::Check& check) {
  check.require(c.push.size() <= 2, "push", "at most mode 1 and mode 2");
  check.require(c.push.size() < 2 || !c.obstacle.empty(), "obstacle",
                "two pushing modes need a signal that switches");
}

template <class Fields>
void visit_fields(Fields& f, SupervisorConfig& c) {
  f("bs", c.bs);
  f("as", c.as);
  f("supply_current", c.supply_current);
  f("foot_force", c.foot_force);
  f("backbone_rad", c.backbone_rad);
  f("stationary_hind_pose_rad", c.stationary_hind_pose_rad);
  f("inputs", c.inputs);
  f("strategies", c.strategies);
}

SupervisorConfig load_config(const std::filesystem::path& path) {
  return config::load<SupervisorConfig>(path);
}

SupervisorConfig load_config_text(const std::string& file, const std::string& text) {
  return config::load_text<SupervisorConfig>(file, text);
}

std::string dump_config(const SupervisorConfig& config) { return config::dump(config); }

std::string config_schema() {
  return config::schema<SupervisorConfig>("Scarab: config/supervisor");
}

}  // namespace scarab::supervisor
