#include "tools/search/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "tools/search/cost.hpp"

namespace scarab::search {
namespace {

/// A penalty and where its measure stands.
struct PenaltyRule {
  const char* name;
  Penalty Penalties::*penalty;
  double Measure::*measure;
};

constexpr std::array<PenaltyRule, 3> kPenaltyRules = {
    {{"leg_leg_share", &Penalties::leg_leg_share, &Measure::leg_leg_share},
     {"carry_share", &Penalties::carry_share, &Measure::carry_share},
     {"approach_pitch_rad", &Penalties::approach_pitch_rad, &Measure::approach_pitch_rad}}};

double total_weight(const Description& description) {
  double sum = 0;
  for (const Scenario& scenario : description.scenarios) sum += scenario.weight;
  return sum;
}

std::vector<ScenarioScore> score_scenarios(const Description& description, const Plan& plan,
                                           const Measures& measures) {
  std::vector<ScenarioScore> scores(description.scenarios.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    ScenarioScore& score = scores[plan[i].scenario];
    ++score.trials;
    score.cost += trial_cost(description.scenarios[plan[i].scenario], measures[i]);
    score.heading_rad = std::max(score.heading_rad, measures[i].heading_max_rad);
    if (!measures[i].success) continue;
    ++score.successes;
    score.time_s += measures[i].time_s;
  }
  for (std::size_t i = 0; i < scores.size(); ++i) {
    scores[i].name = description.scenarios[i].name;
    scores[i].cost /= std::max(1U, scores[i].trials);
    scores[i].time_s /= std::max(1U, scores[i].successes);
  }
  return scores;
}

/// Weight of one trial in the mean over scenarios.
double trial_weight(const Description& description, const std::vector<ScenarioScore>& scores,
                    std::size_t scenario) {
  return description.scenarios[scenario].weight / scores[scenario].trials /
         total_weight(description);
}

AddedTerm penalty_term(const Description& description, const Plan& plan, const Measures& measures,
                       const std::vector<ScenarioScore>& scores, const PenaltyRule& rule) {
  const Penalty& penalty = description.penalties.*rule.penalty;
  AddedTerm term{rule.name, 0, 0};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const double weight = trial_weight(description, scores, plan[i].scenario);
    const double measured = measures[i].*rule.measure;
    term.measured += weight * measured;
    term.value += weight * penalty.weight * excess(penalty, measured);
  }
  return term;
}

/// Mean share of the time limit that a scenario's successes took; none without any.
std::optional<double> time_share(const Description& description,
                                 const std::vector<ScenarioScore>& scores,
                                 const std::string& name) {
  const auto found = std::find_if(scores.begin(), scores.end(),
                                  [&](const ScenarioScore& s) { return s.name == name; });
  if (found->successes == 0) return std::nullopt;
  const auto index = static_cast<std::size_t>(found - scores.begin());
  return found->time_s / description.scenarios[index].time_limit_s;
}

/// Of the successes alone: by mean cost the slower one would be slow enough as soon as some of its
/// trials failed, which costs the objective less than the order is worth. Who never arrives is not
/// the slower one either.
AddedTerm order_term(const Description& description, const std::vector<ScenarioScore>& scores,
                     const Order& order) {
  const auto faster = time_share(description, scores, order.faster);
  const auto slower = time_share(description, scores, order.slower);
  const double difference = faster && slower ? *faster - *slower : 1;
  return {order.faster + " < " + order.slower, difference,
          order.weight * std::clamp(difference + order.margin, 0.0, 1.0)};
}

}  // namespace

Score score(const Description& description, const Plan& plan, const Measures& measures) {
  Score result;
  result.scenarios = score_scenarios(description, plan, measures);
  for (std::size_t i = 0; i < result.scenarios.size(); ++i) {
    result.objective +=
        description.scenarios[i].weight * result.scenarios[i].cost / total_weight(description);
  }
  for (const PenaltyRule& rule : kPenaltyRules) {
    result.terms.push_back(penalty_term(description, plan, measures, result.scenarios, rule));
  }
  for (const Order& order : description.orders) {
    result.terms.push_back(order_term(description, result.scenarios, order));
  }
  for (const AddedTerm& term : result.terms) result.objective += term.value;
  return result;
}

std::string score_table(const Score& score) {
  std::string text = fmt::format("{:<28} {:>9} {:>8} {:>8} {:>9}\n", "scenario", "success",
                                 "mean s", "cost", "heading");
  for (const ScenarioScore& s : score.scenarios) {
    const std::string time = s.successes > 0 ? fmt::format("{:.1f}", s.time_s) : "-";
    text += fmt::format("{:<28} {:>9} {:>8} {:>8.3f} {:>5.1f} deg\n", s.name,
                        fmt::format("{}/{}", s.successes, s.trials), time, s.cost,
                        s.heading_rad * 57.29577951308232);
  }
  for (const AddedTerm& term : score.terms) {
    text += fmt::format("{:<28} {:>9.3f} {:>8} {:>8.3f}\n", term.name, term.measured, "added",
                        term.value);
  }
  return text + fmt::format("{:<28} {:>9} {:>8} {:>8.4f}\n", "objective", "", "", score.objective);
}

}  // namespace scarab::search
