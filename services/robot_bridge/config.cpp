#include "services/robot_bridge/config.hpp"

#include <cmath>

#include "common/config/config.hpp"

namespace scarab::bridge {
namespace {

constexpr double kNsPerS = 1e9;
constexpr config::Range kPeriod{1e-3, 10};
constexpr config::Range kReadings{1, 100};

/// `period` is a whole number of `part`s, to the nanosecond.
bool divides(double part_s, double period_s) {
  return std::llround(period_s * kNsPerS) % std::llround(part_s * kNsPerS) == 0;
}

/// Calls visit(name, section) for each driver.
template <class Sections, class Visit, std::size_t... kIndex>
void for_each(Sections& sections, const Visit& visit, std::index_sequence<kIndex...>) {
  (visit(kDriverNames[kIndex], std::get<kIndex>(sections)), ...);
}

template <class Sections, class Visit>
void for_each_section(Sections& sections, const Visit& visit) {
  for_each(sections, visit, std::make_index_sequence<kDriverNames.size()>());
}

}  // namespace

unsigned samples_per_tick(const TimingConfig& timing) {
  return static_cast<unsigned>(std::lround(timing.control_period_s / timing.sensor_period_s));
}

/// Found by argument-dependent lookup, like every enum_names().
std::array<std::pair<std::string_view, DriverName>, kDriverNames.size()> enum_names(DriverName) {
  std::array<std::pair<std::string_view, DriverName>, kDriverNames.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = {kDriverNames[i], DriverName{i}};
  return names;
}

constexpr std::array<std::pair<std::string_view, SafeStop>, 2> enum_names(SafeStop) {
  return {{{"hold", SafeStop::kHold}, {"release", SafeStop::kRelease}}};
}

template <class Fields>
void visit_fields(Fields& f, TimingConfig& c) {
  f("control_period_s", c.control_period_s, kPeriod);
  f("sensor_period_s", c.sensor_period_s, kPeriod);
}

void validate(const TimingConfig& c, const config::Check& check) {
  check.require(divides(c.sensor_period_s, c.control_period_s), "control_period_s",
                "must be a whole number of sensor periods (sensor_period_s)");
}

template <class Fields>
void visit_fields(Fields& f, StartPose& c) {
  f("front_rad", c.front_rad);
  f("middle_rad", c.middle_rad);
  f("hind_rad", c.hind_rad);
  f("backbone_rad", c.backbone_rad);
}

template <class Fields>
void visit_fields(Fields& f, LimitsConfig& c) {
  f("confirm_readings", c.confirm_readings, kReadings);
  f("clear_fraction", c.clear_fraction, config::Range{0, 1, true});
  f("temperature_max_c", c.temperature_max_c, config::kPositive);
  f("joint_current_max_a", c.joint_current_max_a, config::kPositive);
  f("supply_current_max_a", c.supply_current_max_a, config::kPositive);
  f("inclination_max_rad", c.inclination_max_rad, config::kPositive);
}

template <class Fields>
void visit_fields(Fields& f, BridgeConfig& c) {
  f("driver", c.driver);
  f("timing", c.timing);
  f("start", c.start);
  f("homing_velocity_rad_s", c.homing_velocity_rad_s, config::Range{0, 3, true});
  f("safe_stop", c.safe_stop);
  f("limits", c.limits);
  f("calibration", c.calibration);
  for_each_section(c.sections,
                   [&f](std::string_view name, auto& section) { f.optional(name, section); });
}

void validate(const BridgeConfig& c, const config::Check& check) {
  const std::string_view chosen = kDriverNames[index_of(c.driver)];
  for_each_section(c.sections, [&](std::string_view name, const auto& section) {
    check.require(name != chosen || section.has_value(), name,
                  "is missing: the section of the driver that `driver` names");
  });
}

BridgeConfig load_config(const std::filesystem::path& path) {
  const config::Document document = config::read_extended(path);
  const config::Cursor top(document);
  BridgeConfig config;
  config::read(top, config);
  const auto calibration = std::filesystem::absolute(path).parent_path() / config.calibration;
  config.calibration = calibration.lexically_normal().string();
  config::Check(top).require(std::filesystem::is_regular_file(calibration), "calibration",
                             "there is no file " + config.calibration);
  return config;
}

BridgeConfig load_config_text(const std::string& file, const std::string& text) {
  return config::load_text<BridgeConfig>(file, text);
}

std::string dump_config(const BridgeConfig& config) { return config::dump(config); }

std::string config_schema() { return config::schema<BridgeConfig>("Scarab: config/robot_bridge"); }

}  // namespace scarab::bridge
