#include "tools/search/commands.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "common/runtime/program.hpp"
#include "tools/search/interruption.hpp"
#include "tools/search/objective.hpp"
#include "tools/search/search_run.hpp"
#include "tools/search/write_winner.hpp"

namespace scarab::search {
namespace {

unsigned cores() { return std::max(1U, std::thread::hardware_concurrency()); }

/// Runs `body`; a directory that is of another search is one line and bad usage.
template <class Body>
int reporting(const Body& body) {
  try {
    return body();
  } catch (const WrongDirectory& error) {
    std::cerr << "scarab-search: " << error.what() << '\n';
    return runtime::kExitBadUsage;
  }
}

void add_file(CLI::App& command, std::string& file) {
  command.add_option("file", file, "what to search for (config/search/*.yaml)")
      ->required()
      ->type_name("FILE");
}

void add_jobs(CLI::App& command, unsigned& jobs) {
  jobs = cores();
  command.add_option("--jobs", jobs, "trials side by side; default: as many as there are cores")
      ->check(CLI::Range(1U, 1024U));
}

struct EvaluateOptions {
  std::string file;
  std::string candidate;
  bool held_out = false;
  bool as_searched = false;
  bool failures = false;
  std::uint64_t seeds = UINT64_MAX;
  unsigned jobs = 1;
};

/// Each trial that did not go as its scenario wants.
void print_failures(const Description& description, const Plan& plan, const Measures& measures) {
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Scenario& scenario = description.scenarios[plan[i].scenario];
    if (measures[i].success == (scenario.wanted != Wanted::kFailure)) continue;
    std::cout << scenario.name << ", seed " << plan[i].seed << ": " << measures[i].reason << '\n';
  }
}

int run_evaluate(const EvaluateOptions& chosen) {
  const Problem problem(chosen.file);
  const RunDirectory directory(chosen.candidate);
  std::vector<double> values;
  if (!chosen.candidate.empty()) {
    const auto winner = directory.read_winner(problem.space());
    if (!winner) throw WrongDirectory(chosen.candidate + ": has no winner yet");
    values = winner->values;
  }
  const Seeds& seeds = problem.description().seeds;
  const SeedRange& range = chosen.held_out ? seeds.held_out : seeds.validation;
  const Plan plan = plan_over(problem.description(), range, chosen.seeds);
  const auto fidelity = chosen.as_searched ? Fidelity::kSearch : Fidelity::kFull;
  const sim::Configuration configuration = problem.tree(values, fidelity).build();
  EvaluationOptions options;
  options.jobs = chosen.jobs;
  options.give_up = chosen.as_searched;
  options.interrupted = &watch_for_interruption();
  const auto measures = evaluate(problem.description(), {configuration}, plan, options);
  if (measures.empty()) return runtime::kExitInterrupted;
  const std::uint64_t last = range.first + std::min(range.last - range.first, chosen.seeds - 1);
  const std::string title = std::string(chosen.held_out ? "held-out" : "validation") + " seeds " +
                            std::to_string(range.first) + ".." + std::to_string(last) + "\n";
  const std::string table = title + score_table(score(problem.description(), plan, measures[0]));
  std::cout << table;
  if (chosen.failures) print_failures(problem.description(), plan, measures[0]);
  const bool keep = !chosen.candidate.empty() && chosen.held_out && !chosen.as_searched;
  if (keep) directory.write("held_out.txt", table);
  return runtime::kExitSuccess;
}

int run_write(const std::string& folder, const std::string& to) {
  const RunDirectory directory(folder);
  const Problem problem(directory.identity().file);
  for (const auto& file : write_winner(problem, directory, to)) std::cout << file.string() << '\n';
  return runtime::kExitSuccess;
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("run", "search, or go on with a search");
  command->footer(
      "Example: scarab-search run config/search/beetle.yaml --out runs/search/beetle --minutes 60\n"
      "The same command goes on where it was interrupted.");
  const auto file = std::make_shared<std::string>();
  const auto options = std::make_shared<RunOptions>();
  add_file(*command, *file);
  command->add_option("--out", options->out, "directory of the search")
      ->required()
      ->type_name("DIR");
  command->add_option("--generations", options->generations, "until there are so many")
      ->check(CLI::Range(0U, 1000000U))
      ->capture_default_str();
  command->add_option("--minutes", options->minutes, "no new generation after so long; 0: no limit")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_option("--islands", options->identity.islands, "independent optimisers side by side")
      ->check(CLI::Range(1U, 1000U))
      ->capture_default_str();
  command->add_option("--seed", options->identity.seed, "of all that is random in the search")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  add_jobs(*command, options->jobs);
  command->add_flag("--fresh", options->fresh, "throw away the search that is in the directory");
  command->add_flag("--quiet", options->quiet, "say only how it ended");
  command->callback([&chosen, file, options] {
    chosen = [file, options] {
      return reporting([&] {
        options->identity.file = std::filesystem::absolute(*file).lexically_normal();
        return run_search(Problem(*file), *options);
      });
    };
  });
}

void add_evaluate(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("evaluate", "success rates and times of the base files or of a winner");
  command->footer(
      "Example: scarab-search evaluate config/search/beetle.yaml --candidate runs/search/beetle "
      "--held-out");
  const auto options = std::make_shared<EvaluateOptions>();
  add_file(*command, options->file);
  command->add_option("--candidate", options->candidate, "the winner of this search")
      ->type_name("DIR");
  command->add_flag("--held-out", options->held_out,
                    "on the held-out seeds; with --candidate the table is kept for `write`");
  command->add_option("--seeds", options->seeds, "at most so many of them")
      ->check(CLI::Range(1U, 1000000U));
  command->add_flag("--as-searched", options->as_searched,
                    "with the overrides of the search, and giving up as it does");
  command->add_flag("--failures", options->failures, "list the trials that went wrong");
  add_jobs(*command, options->jobs);
  command->callback([&chosen, options] {
    chosen = [options] { return reporting([&] { return run_evaluate(*options); }); };
  });
}

void add_write(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("write", "write the winner into the configuration");
  command->footer("Example: scarab-search write runs/search/beetle");
  const auto folder = std::make_shared<std::string>();
  const auto to = std::make_shared<std::string>();
  command->add_option("dir", *folder, "directory of the search")->required()->type_name("DIR");
  command->add_option("--to", *to, "write below this folder, DIR/KIND/NAME.yaml; default: in place")
      ->type_name("DIR");
  command->callback([&chosen, folder, to] {
    chosen = [folder, to] { return reporting([&] { return run_write(*folder, *to); }); };
  });
}

void add_check(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("check", "read files of config/search, with their base");
  command->footer("Example: scarab-search check config/search/*.yaml");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("file", *files, "descriptions (YAML)")->required()->type_name("FILE");
  command->callback([&chosen, files] {
    chosen = [files] {
      for (const std::string& file : *files) {
        (void)Problem(file);
        std::cout << file << ": ok\n";
      }
      return runtime::kExitSuccess;
    };
  });
}

void add_schema(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("schema", "print the JSON Schema of the files in config/search");
  command->footer("Example: scarab-search schema > config/schema/search.json");
  command->callback([&chosen] {
    chosen = [] {
      std::cout << description_schema();
      return runtime::kExitSuccess;
    };
  });
}

}  // namespace scarab::search
