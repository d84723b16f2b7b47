#pragma once

namespace scarab::plant {

/// How a sensor's readings differ from the truth (sensor_errors.hpp has the equations). Units are
/// those of the sensor; all 0: an ideal sensor.
struct SensorErrors {
  double noise = 0;      ///< standard deviation of every reading
  double bias = 0;       ///< standard deviation of an offset, constant within a trial
  double quantum = 0;    ///< step between possible readings; 0: no steps
  double latency_s = 0;  ///< age of the truth that a reading tells; a whole number of steps
  double dropout = 0;    ///< probability that a sample is lost; the last reading stays
};

/// What a sensor measures: the unit in the names of its keys.
enum class Quantity { kAngle, kAngularVelocity, kTorque, kForce, kAcceleration, kCurrent };

template <Quantity kQuantity>
struct SensorConfig : SensorErrors {};

struct SensorsConfig {
  SensorConfig<Quantity::kAngle> joint_position;              ///< the encoder of each servo
  SensorConfig<Quantity::kAngularVelocity> joint_velocity;    ///< each servo's own estimate
  SensorConfig<Quantity::kTorque> joint_torque;               ///< each servo's, from its current
  SensorConfig<Quantity::kForce> foot_force;                  ///< each foot's sensor
  SensorConfig<Quantity::kAngle> inclination;                 ///< of the IMU, roll and pitch
  SensorConfig<Quantity::kAngularVelocity> angular_velocity;  ///< of the IMU, three axes
  SensorConfig<Quantity::kAcceleration> acceleration;         ///< of the IMU, three axes
  SensorConfig<Quantity::kCurrent> supply_current;            ///< one, of the whole robot
};

/// The way of a command to the servos (command_delay.hpp); whole numbers of steps.
struct CommandPathConfig {
  double latency_s = 0;  ///< of every command
  double jitter_s = 0;   ///< on top of it, uniform in [0, jitter_s], drawn for each command
};

}  // namespace scarab::plant
