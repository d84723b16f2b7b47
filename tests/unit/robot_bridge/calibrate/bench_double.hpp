#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "services/robot_bridge/calibrate/console.hpp"
#include "services/robot_bridge/core/driver.hpp"

namespace scarab::bridge::calibrate {

/// Servos that stand where the test puts them, and note what they are told.
class ServosInHand : public Driver {
 public:
  robot::JointVector angle_rad{};
  std::optional<std::size_t> mute;  ///< joint that tells no angle
  std::optional<robot::JointVector> activated_rad;
  std::vector<robot::JointVector> written_rad;

  void open() override {}
  void close() noexcept override {}
  Readings read() override {
    Readings readings;
    readings.position_rad.value = angle_rad;
    readings.position_rad.source.fill(Source::kMeasured);
    if (mute) readings.position_rad.source[*mute] = Source::kAbsent;
    return readings;
  }
  void activate(const robot::JointVector& hold_rad) override { activated_rad = hold_rad; }
  void write(const robot::JointVector& target_rad) override { written_rad.push_back(target_rad); }
  bool hold() noexcept override { return true; }
  bool release() noexcept override { return true; }
  [[nodiscard]] Capabilities capabilities() const override { return {}; }
  [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> counters() const override {
    return {};
  }
};

/// A person who does one thing after the other: moves a joint, presses a key. Then the input ends.
class Person : public Console {
 public:
  explicit Person(ServosInHand& servos) : servos_(servos) {}

  Person& moves(std::size_t joint, double servo_rad) {
    deeds_.push_back({joint, servo_rad, Key::kNone});
    return *this;
  }
  Person& presses(Key key, int times = 1) {
    for (int i = 0; i < times; ++i) deeds_.push_back({0, std::nullopt, key});
    return *this;
  }

  Key key(std::chrono::milliseconds /*longest*/) override {
    if (deeds_.empty()) return Key::kQuit;
    const Deed deed = deeds_.front();
    deeds_.pop_front();
    if (deed.servo_rad) servos_.angle_rad[deed.joint] = *deed.servo_rad;
    return deed.key;
  }
  void line(const std::string& text) override { heard += text + "\n"; }
  void live(const std::string& /*text*/) override {}

  std::string heard;

 private:
  struct Deed {
    std::size_t joint;
    std::optional<double> servo_rad;
    Key key;
  };

  ServosInHand& servos_;
  std::deque<Deed> deeds_;
};

}  // namespace scarab::bridge::calibrate
