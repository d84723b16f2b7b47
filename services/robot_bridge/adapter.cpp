#include "services/robot_bridge/adapter.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace scarab::bridge {
namespace {

constexpr bool same(Source core, scarab_Source idl) {
  return static_cast<int>(core) == static_cast<int>(idl);
}

static_assert(same(Source::kAbsent, scarab_SOURCE_ABSENT) &&
              same(Source::kMeasured, scarab_SOURCE_MEASURED) &&
              same(Source::kCommanded, scarab_SOURCE_COMMANDED));

scarab_Source to_idl(Source source) { return static_cast<scarab_Source>(source); }

template <std::size_t N>
void copy(const std::array<double, N>& values, const std::array<Source, N>& sources,
          double (&to_values)[N], scarab_Source (&to_sources)[N]) {
  for (std::size_t i = 0; i < N; ++i) {
    to_values[i] = sources[i] == Source::kAbsent ? 0 : values[i];
    to_sources[i] = to_idl(sources[i]);
  }
}

}  // namespace

void fill(scarab_RobotState& state, const Readings& r) {
  copy(r.position_rad.value, r.position_rad.source, state.position_rad, state.position_source);
  copy(r.velocity_rad_s.value, r.velocity_rad_s.source, state.velocity_rad_s,
       state.velocity_source);
  copy(r.torque_nm.value, r.torque_nm.source, state.torque_nm, state.torque_source);
  copy(r.foot_force_n, r.foot_force_source, state.foot_force_n, state.foot_force_source);
  state.imu_source = to_idl(r.imu_source);
  if (r.imu_source != Source::kAbsent) {
    state.inclination_rad[0] = r.roll_rad;
    state.inclination_rad[1] = r.pitch_rad;
  }
  state.motion_source = to_idl(r.motion_source);
  if (r.motion_source != Source::kAbsent) {
    std::copy(r.angular_velocity_rad_s.begin(), r.angular_velocity_rad_s.end(),
              std::begin(state.angular_velocity_rad_s));
    std::copy(r.acceleration_m_s2.begin(), r.acceleration_m_s2.end(),
              std::begin(state.acceleration_m_s2));
  }
  state.supply_current_source = to_idl(r.supply_current_source);
  if (r.supply_current_source != Source::kAbsent) state.supply_current_a = r.supply_current_a;
}

}  // namespace scarab::bridge
