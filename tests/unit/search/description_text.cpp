#include "tests/unit/search/description_text.hpp"

#include <stdexcept>

#include "tests/support/programs.hpp"

namespace scarab::search {

std::string description_text(const std::string& from, const std::string& to) {
  const std::string config = test::source_file("config");
  std::string text = "title: a test\nbase:\n  robot: " + config +
                     "/robot/beetle.yaml\n  plant: " + config +
                     "/plant/beetle.yaml\n  premotor: " + config +
                     "/premotor/beetle.yaml\n  supervisor: " + config + R"(/supervisor/beetle.yaml
overrides:
  plant.timing.step_s: 0.004
parameters:
  premotor.motor.front.t_gain_rad: {low: -5, high: 5}
  plant.start.settle_s: {low: 0, high: 2}
ties:
  plant.start.front_rad.0: premotor.motor.front.t_offset_rad
  supervisor.as.window_ticks: cpg_period_ticks
scenarios:
  - {name: flat, strategy: soft, goal: travel, time_limit_s: 60, seeds: 2, weight: 1}
  - {name: wall, strategy: soft+hard, goal: across, height_m: 0.1, time_limit_s: 60, seeds: 3, weight: 2}
penalties:
  leg_leg_share: {bound: 0.1, worst: 0.5, weight: 0.5}
orders:
  - {faster: flat, slower: wall, margin: 0.1, weight: 0.25}
seeds:
  search: {first: 1, last: 899999}
  validation: {first: 900001, last: 900004}
  held_out: {first: 2000001, last: 2000040}
optimiser: {population: 6, sigma: 0.1, validate_every: 2}
)";
  if (from.empty()) return text;
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument("not in the description: " + from);
  return text.replace(at, from.size(), to);
}

Description description_from(const std::string& text) {
  return read_description(config::parse_text("search.yaml", text));
}

}  // namespace scarab::search
