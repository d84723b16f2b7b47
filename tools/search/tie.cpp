#include "tools/search/tie.hpp"

#include <cmath>
#include <stdexcept>

#include "services/premotor/core/cpg.hpp"
#include "services/premotor/core/network.hpp"

namespace scarab::search {
namespace {

constexpr int kWarmupTicks = 500;
constexpr int kCountedTicks = 4000;
constexpr const char* kCpgPeriod = "cpg_period_ticks";

bool is_path(const std::string& source) { return source.find('.') != std::string::npos; }

double value_of(const ConfigurationTree& tree, const std::string& source) {
  if (is_path(source)) return tree.number(source);
  return cpg_period_ticks(tree.number("premotor.network.cpg.w11"),
                          tree.number("premotor.network.cpg.w12"));
}

/// By how far the orbit goes round from one step to the next, in (-pi, pi].
double turned_rad(double x, double y, double next_x, double next_y) {
  return std::atan2(x * next_y - y * next_x, x * next_x + y * next_y);
}

}  // namespace

double cpg_period_ticks(double w11, double w12) {
  premotor::NetworkDescription description;
  for (const char* name : {"I1", "I2", "I3", "I4"}) description.add_input(name);
  const premotor::CpgNeurons cpg = premotor::add_cpg(description, {w11, w12, {0.1, 0.1}});
  const premotor::Network network(description);
  const auto c1 = static_cast<Eigen::Index>(cpg.c1);
  const auto c2 = static_cast<Eigen::Index>(cpg.c2);
  Eigen::VectorXd output = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(network.size()));
  output[c1] = output[c2] = 0.1;
  double turned = 0;
  for (int tick = 0; tick < kWarmupTicks + kCountedTicks; ++tick) {
    const Eigen::VectorXd next = network.step(output, {});
    if (tick >= kWarmupTicks) turned += turned_rad(output[c1], output[c2], next[c1], next[c2]);
    output = next;
  }
  if (std::abs(turned) < 2 * M_PI) throw std::invalid_argument("the CPG does not oscillate");
  return std::round(100 * 2 * M_PI * kCountedTicks / std::abs(turned)) / 100;
}

std::string refusal_of_tie(const ConfigurationTree& tree, const Ties& ties,
                           const std::string& path) {
  const std::string& source = ties.at(path);
  if (!tree.has_number(path)) return "no number in the base files";
  if (!is_path(source)) {
    return source == kCpgPeriod ? "" : "no function '" + source + "'; there is " + kCpgPeriod;
  }
  if (!tree.has_number(source)) return "'" + source + "' is no number in the base files";
  if (ties.count(source) != 0) return "'" + source + "' is tied itself";
  return "";
}

void apply_ties(ConfigurationTree& tree, const Ties& ties) {
  for (const auto& [path, source] : ties) tree.set_number(path, value_of(tree, source));
}

}  // namespace scarab::search
