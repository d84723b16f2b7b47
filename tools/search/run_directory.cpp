#include "tools/search/run_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "common/config/cursor.hpp"
#include "common/config/document.hpp"
#include "common/config/scalar.hpp"
#include "common/runtime/text_file.hpp"

namespace scarab::search {
namespace {

constexpr const char* kSeedFile = "identity/seed.yaml";
constexpr const char* kDescriptionFile = "identity/description.yaml";
constexpr const char* kCostsFile = "costs.csv";
constexpr const char* kWinnerFile = "winner.yaml";
constexpr const char* kCostsHeader = "generation,island,candidate,cost\n";

/// Name of a file -> its text: all that says which search this is.
std::map<std::string, std::string> description_texts(const Problem& problem) {
  std::map<std::string, std::string> texts;
  texts[kDescriptionFile] = dump_description(problem.description());
  for (const std::string_view kind : kKinds) {
    texts["identity/" + std::string(kind) + ".yaml"] = problem.base().text(kind);
  }
  return texts;
}

std::string seed_text(const Identity& identity) {
  return fmt::format("seed: {}\nislands: {}\nfile: \"{}\"\n", identity.seed, identity.islands,
                     identity.file.string());
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw WrongDirectory(path.string() + ": " + why);
}

}  // namespace

void RunDirectory::claim(const Problem& problem, const Identity& wanted, bool fresh) const {
  if (fresh) {
    for (const char* name : {kSeedFile, kCostsFile, kWinnerFile, "history.csv", "held_out.txt"}) {
      std::filesystem::remove(path_ / name);
    }
  }
  if (read(kSeedFile)) {
    expect_description(problem);
    const Identity found = identity();
    if (found.seed == wanted.seed && found.islands == wanted.islands) return;
    refuse(path_, fmt::format("holds a search with --seed {} --islands {}; name another --out, or "
                              "start anew with --fresh",
                              found.seed, found.islands));
  }
  const bool stray = std::filesystem::exists(path_ / kCostsFile);
  if (stray) refuse(path_, "has costs.csv but does not say of which search; use --fresh");
  std::filesystem::create_directories(path_ / "identity");
  for (const auto& [name, text] : description_texts(problem)) write(name, text);
  write(kSeedFile, seed_text(wanted));  // last: with it the identity is whole
}

void RunDirectory::expect_description(const Problem& problem) const {
  for (const auto& [name, text] : description_texts(problem)) {
    if (read(name) == text) continue;
    refuse(path_, "holds the search of another description: " + name +
                      " differs from what is asked for now; name another --out, or start anew "
                      "with --fresh");
  }
}

Identity RunDirectory::identity() const {
  const auto text = read(kSeedFile);
  if (!text) refuse(path_, "no search is kept here");
  const config::Document document = config::parse_text((path_ / kSeedFile).string(), *text);
  const config::Cursor at(document);
  return {at.at("seed").unsigned_integer(UINT64_MAX, config::kAny),
          static_cast<unsigned>(at.at("islands").unsigned_integer(1000, config::kAny)),
          at.at("file").text()};
}

ConfigurationTree RunDirectory::base() const {
  return {{"robot.yaml", "plant.yaml", "premotor.yaml", "supervisor.yaml"}, path_ / "identity"};
}

std::vector<GenerationCosts> RunDirectory::read_costs() const {
  std::vector<GenerationCosts> costs;
  std::istringstream lines(read(kCostsFile).value_or(""));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::size_t generation = 0;
    std::size_t island = 0;
    std::size_t candidate = 0;
    char comma = 0;
    std::string cost;
    cells >> generation >> comma >> island >> comma >> candidate >> comma >> cost;
    const auto value = config::parse_number(cost).value;
    if (!cells || !value || generation == 0) refuse(path_, "costs.csv is damaged: " + line);
    costs.resize(std::max(costs.size(), generation));
    GenerationCosts& now = costs[generation - 1];
    now.resize(std::max(now.size(), island + 1));
    if (candidate != now[island].size()) refuse(path_, "costs.csv is damaged: " + line);
    now[island].push_back(*value);
  }
  return costs;
}

void RunDirectory::write_costs(const std::vector<GenerationCosts>& costs) const {
  std::string text = kCostsHeader;
  for (std::size_t generation = 0; generation < costs.size(); ++generation) {
    for (std::size_t island = 0; island < costs[generation].size(); ++island) {
      const auto& told = costs[generation][island];
      for (std::size_t i = 0; i < told.size(); ++i) {
        text +=
            fmt::format("{},{},{},{}\n", generation + 1, island, i, config::format_number(told[i]));
      }
    }
  }
  write(kCostsFile, text);
}

std::optional<Winner> RunDirectory::read_winner(const ParameterSpace& space) const {
  const auto text = read(kWinnerFile);
  if (!text) return std::nullopt;
  const config::Document document = config::parse_text((path_ / kWinnerFile).string(), *text);
  const config::Cursor at(document);
  Winner winner;
  winner.generation =
      static_cast<unsigned>(at.at("generation").unsigned_integer(UINT32_MAX, config::kAny));
  winner.objective = at.at("objective").number(config::kAny);
  winner.start_objective = at.at("start_objective").number(config::kAny);
  for (const Parameter& parameter : space.parameters()) {
    winner.values.push_back(
        at.at("values").at(parameter.path).number({parameter.low, parameter.high}));
  }
  return winner;
}

void RunDirectory::write_winner(const Winner& winner, const ParameterSpace& space) const {
  std::string text = fmt::format(
      "# Best of the search so far, judged on the validation seeds; written by scarab-search.\n"
      "generation: {}\nobjective: {}\nstart_objective: {}\nvalues:\n",
      winner.generation, config::format_number(winner.objective),
      config::format_number(winner.start_objective));
  for (std::size_t i = 0; i < winner.values.size(); ++i) {
    text +=
        "  " + space.parameters()[i].path + ": " + config::format_number(winner.values[i]) + "\n";
  }
  write(kWinnerFile, text);
}

void RunDirectory::write(const std::string& name, const std::string& text) const {
  const std::filesystem::path file = path_ / name;
  const std::filesystem::path unfinished = file.string() + ".new";
  runtime::write_text(unfinished, text);
  std::filesystem::rename(unfinished, file);
}

std::optional<std::string> RunDirectory::read(const std::string& name) const {
  std::ifstream file(path_ / name, std::ios::binary);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace scarab::search
