#include "tools/search/problem.hpp"

#include <exception>
#include <string>

#include "common/config/cursor.hpp"
#include "common/config/extends.hpp"
#include "common/config/scalar.hpp"
#include "services/supervisor/core/supervisor_config.hpp"
#include "tools/search/tie.hpp"

namespace scarab::search {
namespace {

using config::Cursor;
using config::format_number;

ParameterSpace read_space(const Cursor& at, const Description& description,
                          const ConfigurationTree& base) {
  std::vector<Parameter> parameters;
  for (const auto& [path, bounds] : description.parameters) {
    const Cursor entry = at.at("parameters").at(path);
    if (!base.has_number(path)) entry.fail("no number in the base files");
    const double start = base.number(path);
    if (start < bounds.low || start > bounds.high) {
      entry.fail("the base file has " + format_number(start) + ", outside of the interval");
    }
    parameters.push_back({path, bounds.low, bounds.high, start});
  }
  return ParameterSpace(std::move(parameters));
}

void check_overrides(const Cursor& at, const Description& description,
                     const ConfigurationTree& base) {
  for (const auto& entry : description.overrides) {
    const std::string& path = entry.first;
    const Cursor place = at.at("overrides").at(path);
    if (!base.has_number(path)) place.fail("no number in the base files");
    if (description.parameters.count(path) != 0) place.fail("is a parameter, too");
  }
}

void check_ties(const Cursor& at, const Description& description, const ConfigurationTree& base) {
  for (const auto& entry : description.ties) {
    const std::string& path = entry.first;
    const Cursor place = at.at("ties").at(path);
    const std::string refusal = refusal_of_tie(base, description.ties, path);
    if (!refusal.empty()) place.fail(refusal);
    if (description.parameters.count(path) != 0) place.fail("is a parameter, too");
  }
}

void check_strategies(const Cursor& at, const Description& description,
                      const supervisor::SupervisorConfig& config) {
  const std::vector<Cursor> scenarios = at.at("scenarios").elements();
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    const std::string& strategy = description.scenarios[i].strategy;
    const std::string refusal = supervisor::refusal_of_strategy(config, strategy);
    if (!refusal.empty()) scenarios[i].at("strategy").fail(refusal);
  }
}

/// Either end of each interval must make a configuration that the services accept.
void check_ends(const Cursor& at, const Problem& problem) {
  const auto& parameters = problem.space().parameters();
  std::vector<double> values;
  values.reserve(parameters.size());
  for (const Parameter& parameter : parameters) values.push_back(parameter.start);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    for (const double end : {parameters[i].low, parameters[i].high}) {
      std::vector<double> changed = values;
      changed[i] = end;
      try {
        (void)problem.tree(changed, Fidelity::kSearch).build();
      } catch (const std::exception& error) {
        const Cursor place = at.at("parameters").at(parameters[i].path);
        place.fail("its end " + format_number(end) + " is refused: " + error.what());
      }
    }
  }
}

}  // namespace

Problem::Problem(const std::filesystem::path& file)
    : file_(file),
      document_(config::read_extended(file)),
      description_(read_description(document_)),
      base_(description_.base, file.parent_path()),
      space_(read_space(Cursor(document_), description_, base_)) {
  const Cursor at(document_);
  check_overrides(at, description_, base_);
  check_ties(at, description_, base_);
  check_strategies(at, description_, base_.build().supervisor);
  check_ends(at, *this);
}

ConfigurationTree Problem::tree(const std::vector<double>& values, Fidelity fidelity) const {
  ConfigurationTree result = base_;
  if (fidelity == Fidelity::kSearch) {
    for (const auto& [path, value] : description_.overrides) result.set_number(path, value);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.set_number(space_.parameters()[i].path, values[i]);
  }
  apply_ties(result, description_.ties);
  return result;
}

}  // namespace scarab::search
