#include "tools/search/write_winner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "common/config/scalar.hpp"
#include "tools/search/scalar_edit.hpp"
#include "tools/search/tie.hpp"
#include "tools/search/value_path.hpp"

namespace scarab::search {
namespace {

using Edits = std::vector<ScalarEdit>;

std::string read_text(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw std::runtime_error(path.string() + ": cannot read");
  return text.str();
}

/// What the search found its values with must still be what they are written beside.
void expect_same_base(const Problem& problem, const RunDirectory& directory, const Winner& winner) {
  ConfigurationTree then = directory.base();
  const auto& parameters = problem.space().parameters();
  for (std::size_t i = 0; i < winner.values.size(); ++i) {
    then.set_number(parameters[i].path, winner.values[i]);
  }
  apply_ties(then, problem.description().ties);
  const ConfigurationTree now = problem.tree(winner.values, Fidelity::kFull);
  for (const std::string_view kind : kKinds) {
    if (then.text(kind) == now.text(kind)) continue;
    throw WrongDirectory(now.document(kind).files[0] +
                         ": has changed since the search in other values than those searched for");
  }
}

/// What has to change in each file.
std::map<std::string, Edits> edits_of(const Problem& problem, const Winner& winner,
                                      std::string_view kind) {
  const ConfigurationTree found = problem.tree(winner.values, Fidelity::kFull);
  std::vector<std::string> paths;
  for (const auto& entry : problem.description().parameters) paths.push_back(entry.first);
  for (const auto& entry : problem.description().ties) paths.push_back(entry.first);
  const config::Document& document = problem.base().document(kind);
  std::map<std::string, Edits> edits;
  for (const std::string& path : paths) {
    const SplitPath split = split_path(path);
    if (split.kind != kind) continue;
    const config::Value* value = find_value(document.root, split.rest);
    Edits& of_file = edits[document.files[value->position.file]];  // its provenance, in any case
    if (problem.base().number(path) == found.number(path)) continue;
    of_file.push_back({value->position, value->text, config::format_number(found.number(path))});
  }
  return edits;
}

/// `config/search/beetle.yaml` of a longer path.
std::string shown(const std::filesystem::path& file) {
  const auto folder = file.parent_path();
  return (folder.parent_path().filename() / folder.filename() / file.filename()).string();
}

}  // namespace

std::vector<std::string> provenance(const Problem& problem, const RunDirectory& directory,
                                    const Winner& winner) {
  const Identity identity = directory.identity();
  const auto costs = directory.read_costs();
  const unsigned population = problem.description().optimiser.population;
  const SeedRange& validation = problem.description().seeds.validation;
  std::vector<std::string> lines = {
      fmt::format("#   {}, --seed {} --islands {}: {} generations, {} candidates",
                  shown(identity.file), identity.seed, identity.islands, costs.size(),
                  costs.size() * identity.islands * population),
      fmt::format("#   objective {:.4f} of generation {}, before {:.4f} (validation seeds {}..{})",
                  winner.objective, winner.generation, winner.start_objective, validation.first,
                  validation.last)};
  std::istringstream held_out(directory.read("held_out.txt").value_or(""));
  for (std::string line; std::getline(held_out, line);) lines.push_back("#   " + line);
  return lines;
}

std::vector<std::filesystem::path> write_winner(const Problem& problem,
                                                const RunDirectory& directory,
                                                const std::filesystem::path& to) {
  const auto winner = directory.read_winner(problem.space());
  if (!winner) throw WrongDirectory(directory.path().string() + ": has no winner yet");
  expect_same_base(problem, directory, *winner);
  const auto lines = provenance(problem, directory, *winner);
  std::vector<std::filesystem::path> written;
  for (const std::string_view kind : kKinds) {
    for (const auto& [file, edits] : edits_of(problem, *winner, kind)) {
      const std::filesystem::path source = file;
      const auto target = to.empty() ? source : to / kind / source.filename();
      const std::string text = with_provenance(edit_scalars(read_text(source), edits), lines);
      std::filesystem::create_directories(target.parent_path());
      RunDirectory(target.parent_path()).write(target.filename().string(), text);
      written.push_back(target);
    }
  }
  return written;
}

}  // namespace scarab::search
