#include "tools/search/description.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "common/config/config.hpp"

namespace scarab::search {
namespace {

constexpr config::Range kHeight{0, 0.5};
constexpr config::Range kTime{0.1, 36000};
constexpr config::Range kDistance{0.01, 10};
constexpr config::Range kCount{1, 10000};

bool overlap(const SeedRange& a, const SeedRange& b) {
  return a.first <= b.last && b.first <= a.last;
}

bool has_scenario(const Description& c, const std::string& name) {
  return std::any_of(c.scenarios.begin(), c.scenarios.end(),
                     [&](const Scenario& scenario) { return scenario.name == name; });
}

}  // namespace

inline auto enum_names(Goal) {
  return std::array<std::pair<std::string_view, Goal>, 4>{{{"travel", Goal::kTravel},
                                                           {"across", Goal::kAcross},
                                                           {"walk", Goal::kWalk},
                                                           {"none", Goal::kNone}}};
}

inline auto enum_names(Wanted) {
  return std::array<std::pair<std::string_view, Wanted>, 3>{{{"success", Wanted::kSuccess},
                                                             {"failure", Wanted::kFailure},
                                                             {"straight", Wanted::kStraight}}};
}

template <class Fields>
void visit_fields(Fields& f, BaseNames& c) {
  f("robot", c.robot);
  f("plant", c.plant);
  f("premotor", c.premotor);
  f("supervisor", c.supervisor);
}

template <class Fields>
void visit_fields(Fields& f, Bounds& c) {
  f("low", c.low);
  f("high", c.high);
}

void validate(const Bounds& c, const config::Check& check) {
  check.require(c.low < c.high, "high", "must be above low");
}

template <class Fields>
void visit_fields(Fields& f, Perturbation& c) {
  f.optional("position_m", c.position_m, config::Range{0, 1});
  f.optional("yaw_rad", c.yaw_rad, config::Range{0, 3.2});
  f.optional("friction", c.friction, config::Range{0, 0.9});
  f.optional("cpg_phase", c.cpg_phase);
}

template <class Fields>
void visit_fields(Fields& f, Scenario& c) {
  f("name", c.name);
  f("strategy", c.strategy);
  f("goal", c.goal);
  f.optional("height_m", c.height_m, kHeight);
  f.optional("distance_m", c.distance_m, kDistance);
  f("time_limit_s", c.time_limit_s, kTime);
  f("seeds", c.seeds, kCount);
  f("weight", c.weight, config::kNonNegative);
  f.optional("wanted", c.wanted);
  f.optional("heading_bound_rad", c.heading_bound_rad, config::kPositive);
  f.optional("friction_scale", c.friction_scale, config::Range{0.1, 10});
  f.optional("object_mass_kg", c.object_mass_kg, config::Range{0, 100});
  f.optional("object_diameter_m", c.object_diameter_m, config::Range{0, 1});
}

void validate(const Scenario& c, const config::Check& check) {
  check.require(c.goal != Goal::kAcross || c.height_m > 0, "goal",
                "across needs an obstacle: height_m greater than 0");
}

template <class Fields>
void visit_fields(Fields& f, Penalty& c) {
  f("bound", c.bound, config::kNonNegative);
  f("worst", c.worst, config::kPositive);
  f("weight", c.weight, config::kNonNegative);
}

void validate(const Penalty& c, const config::Check& check) {
  check.require(c.bound < c.worst, "worst", "must be above bound");
}

template <class Fields>
void visit_fields(Fields& f, Penalties& c) {
  f.optional("leg_leg_share", c.leg_leg_share);
  f.optional("carry_share", c.carry_share);
  f.optional("approach_pitch_rad", c.approach_pitch_rad);
}

template <class Fields>
void visit_fields(Fields& f, Order& c) {
  f("faster", c.faster);
  f("slower", c.slower);
  f.optional("margin", c.margin, config::kNonNegative);
  f("weight", c.weight, config::kNonNegative);
}

template <class Fields>
void visit_fields(Fields& f, SeedRange& c) {
  f("first", c.first);
  f("last", c.last);
}

void validate(const SeedRange& c, const config::Check& check) {
  check.require(c.first <= c.last, "last", "must not be below first");
}

template <class Fields>
void visit_fields(Fields& f, Seeds& c) {
  f("search", c.search);
  f("validation", c.validation);
  f("held_out", c.held_out);
}

void validate(const Seeds& c, const config::Check& check) {
  const std::string limit = std::to_string(kFirstReportedSeed);
  check.require(c.search.last < kFirstReportedSeed, "search.last", "must be below " + limit);
  check.require(c.validation.last < kFirstReportedSeed, "validation.last",
                "must be below " + limit);
  check.require(c.held_out.first > kFirstReportedSeed, "held_out.first",
                "must be above " + limit + ": seeds that a search may see are below");
  check.require(!overlap(c.search, c.validation), "validation",
                "overlaps with the seeds of the search");
}

template <class Fields>
void visit_fields(Fields& f, Optimiser& c) {
  f.optional("population", c.population, config::Range{5, 1000});  // pagmo's CMA-ES wants five
  f.optional("sigma", c.sigma, config::Range{0, 1, true});
  f.optional("validate_every", c.validate_every, kCount);
}

template <class Fields>
void visit_fields(Fields& f, Description& c) {
  f("title", c.title);
  f("base", c.base);
  f.optional("overrides", c.overrides);
  f("parameters", c.parameters);
  f.optional("ties", c.ties);
  f.optional("perturbation", c.perturbation);
  f("scenarios", c.scenarios);
  f.optional("penalties", c.penalties);
  f.optional("orders", c.orders);
  f("seeds", c.seeds);
  f.optional("optimiser", c.optimiser);
  f.optional("give_up_s", c.give_up_s, config::kPositive);
}

void validate(const Description& c, const config::Check& check) {
  check.require(!c.parameters.empty(), "parameters", "nothing to search for");
  check.require(!c.scenarios.empty(), "scenarios", "needs at least one");
  double weights = 0;
  for (std::size_t i = 0; i < c.scenarios.size(); ++i) {
    weights += c.scenarios[i].weight;
    for (std::size_t j = 0; j < i; ++j) {
      check.require(c.scenarios[i].name != c.scenarios[j].name, "scenarios",
                    "two are named '" + c.scenarios[i].name + "'");
    }
  }
  check.require(weights > 0, "scenarios", "at least one must have a weight above 0");
  for (const Order& order : c.orders) {
    for (const std::string& name : {order.faster, order.slower}) {
      check.require(has_scenario(c, name), "orders", "no scenario '" + name + "'");
    }
  }
}

Description read_description(const config::Document& document) {
  Description description;
  config::read(config::Cursor(document), description);
  return description;
}

std::string dump_description(const Description& description) { return config::dump(description); }

std::string description_schema() { return config::schema<Description>("Scarab: config/search"); }

}  // namespace scarab::search
