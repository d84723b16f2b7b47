#include "services/robot_bridge/drivers/amosii/sensors.hpp"

namespace scarab::bridge::amosii {

void add_sensors(const Config& config, const Slots& sensors, Readings& readings) {
  for (std::size_t leg = 0; leg < robot::kLegCount; ++leg) {
    readings.foot_force_n[leg] =
        config.foot_full_scale_n * foot_load(leg, sensors[kFootSlots[leg].slot]);
    readings.foot_force_source[leg] = Source::kMeasured;
  }
  readings.supply_current_a = measured(input_of(config.motor_current), sensors[kMotorCurrentSlot]);
  readings.supply_current_source = Source::kMeasured;
  if (!config.inclinometer) return;
  const Inclinometer& axes = *config.inclinometer;
  readings.roll_rad = measured(input_of(axes.roll), sensors[kInclinometerXSlot]);
  readings.pitch_rad = measured(input_of(axes.pitch), sensors[kInclinometerYSlot]);
  readings.imu_source = Source::kMeasured;
}

}  // namespace scarab::bridge::amosii
