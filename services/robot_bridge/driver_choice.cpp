#include "services/robot_bridge/driver_choice.hpp"

#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <tuple>
#include <utility>

#include "common/config/check.hpp"
#include "common/config/extends.hpp"

namespace scarab::bridge {
namespace {

/// Calls make() of the driver whose place is `chosen`; each is found by its section's namespace.
template <std::size_t... kIndex, class... Rest>
std::unique_ptr<Driver> make_at(std::size_t chosen, const DriverSections& sections,
                                std::index_sequence<kIndex...>, const Rest&... rest) {
  std::unique_ptr<Driver> driver;
  const auto try_one = [&](std::size_t index, const auto& section) {
    if (index == chosen) driver = make(section.value(), rest...);
  };
  (try_one(kIndex, std::get<kIndex>(sections)), ...);
  return driver;
}

}  // namespace

std::unique_ptr<Driver> make_driver(const std::filesystem::path& config_file,
                                    const BridgeConfig& config, const robot::RobotModel& robot,
                                    const Calibration& calibration, const std::string& device) {
  const config::Document document = config::read_extended(config_file);
  const config::Check check{config::Cursor(document)};
  const std::size_t chosen = index_of(config.driver);
  const std::string_view name = kDriverNames[chosen];
  std::unique_ptr<Driver> driver;
  try {
    driver = make_at(chosen, config.sections, std::make_index_sequence<kDriverNames.size()>(),
                     robot, calibration, device);
  } catch (const std::invalid_argument& error) {
    check.require(false, name, error.what());
  }
  const bool can_release = driver->capabilities().torque_switch;
  check.require(config.safe_stop != SafeStop::kRelease || can_release, "safe_stop",
                "the device cannot switch its motors off: say hold");
  return driver;
}

}  // namespace scarab::bridge
