#include "tools/search/cost.hpp"

#include <algorithm>

namespace scarab::search {
namespace {

constexpr double kWayShare = 0.6;
constexpr double kCostAtHeadingBound = 0.25;

double share(double value) { return std::clamp(value, 0.0, 1.0); }

double heading_cost(double deviation_rad, double bound_rad) {
  const double ratio = deviation_rad / bound_rad;
  return kCostAtHeadingBound * share(ratio) + (1 - kCostAtHeadingBound) * share(ratio - 1);
}

}  // namespace

double missing_share(const Scenario& scenario, const Measure& measure) {
  const double way = 1 - share(measure.progress);
  if (scenario.goal != Goal::kAcross) return way;
  return kWayShare * way + (1 - kWayShare) * (1 - share(measure.lift));
}

double trial_cost(const Scenario& scenario, const Measure& measure) {
  const double time = share(measure.time_s / scenario.time_limit_s);
  if (scenario.wanted == Wanted::kFailure) return measure.success ? 1 - time / 2 : 0;
  if (!measure.success) return 1 + missing_share(scenario, measure);
  if (scenario.wanted == Wanted::kSuccess) return time;
  return heading_cost(measure.heading_max_rad, scenario.heading_bound_rad);
}

double excess(const Penalty& penalty, double measured) {
  return share((measured - penalty.bound) / (penalty.worst - penalty.bound));
}

}  // namespace scarab::search
