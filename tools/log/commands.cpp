#include "tools/log/commands.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>

#include "common/mcap/recover.hpp"
#include "tools/log/comparison.hpp"
#include "tools/log/csv.hpp"
#include "tools/log/extraction.hpp"
#include "tools/log/info.hpp"
#include "tools/log/topic_type.hpp"

namespace scarab::log {
namespace {

constexpr int kSuccess = 0;
constexpr int kDifferent = 1;
constexpr int kBadUsage = 2;

CLI::Option* add_file(CLI::App& command, const std::string& name, std::string& file,
                      const std::string& help) {
  return command.add_option(name, file, help)
      ->type_name("FILE")
      ->required()
      ->check(CLI::ExistingFile);
}

struct CompareArguments {
  std::string a;
  std::string b;
  std::vector<std::string> topics;
};

bool has_topic(const mcap::Reader& a, const mcap::Reader& b, const std::string& topic) {
  return find_channel(a, topic) != nullptr || find_channel(b, topic) != nullptr;
}

int compare(const CompareArguments& arguments) {
  const mcap::Reader a(arguments.a);
  const mcap::Reader b(arguments.b);
  warn_if_cut(a, std::cerr);
  warn_if_cut(b, std::cerr);
  int result = kSuccess;
  std::uint64_t compared = 0;
  for (const std::string& topic : arguments.topics.empty() ? chain_topics() : arguments.topics) {
    if (!has_topic(a, b, topic)) {
      if (arguments.topics.empty()) continue;
      std::cerr << "scarab-log: no topic " << topic << " in either log\n";
      return kBadUsage;
    }
    const TopicComparison comparison = compare_topic(a, b, topic);
    compared += comparison.equal_samples;
    std::cout << topic << ": ";
    if (comparison.difference.empty()) {
      std::cout << comparison.equal_samples << " samples equal\n";
    } else {
      std::cout << "differs after " << comparison.equal_samples
                << " equal samples: " << comparison.difference << '\n';
      result = kDifferent;
    }
  }
  if (result == kSuccess && compared == 0) {
    std::cerr << "scarab-log: nothing to compare: neither log has a sample of the topics\n";
    return kBadUsage;
  }
  return result;
}

}  // namespace

void add_info(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("info", "what a log holds: topics, trials, time span");
  auto file = std::make_shared<std::string>();
  add_file(*command, "file", *file, "the log");
  command->callback([&chosen, file] {
    chosen = [file] {
      print_info(mcap::Reader(*file), std::cout);
      return kSuccess;
    };
  });
}

void add_export(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("export", "a topic as a table, on stdout");
  command->alias("csv");
  command->footer(
      "Example: scarab-log export trial.mcap --topic scarab/robot_state --field header.tick "
      "--field position_rad");
  auto file = std::make_shared<std::string>();
  auto options = std::make_shared<CsvOptions>();
  add_file(*command, "file", *file, "the log");
  command->add_option("--topic", options->topic, "the topic")->required();
  auto format = std::make_shared<std::string>("csv");
  command->add_option("--format", *format, "csv")
      ->check(CLI::IsMember({"csv"}))
      ->capture_default_str();
  command->add_option("--trial", options->trial, "only samples of this trial");
  command->add_option(
      "--field", options->fields,
      "a column, or the beginning of several (position_rad); repeatable; all if none");
  command
      ->add_option("--elements", options->sequence_elements,
                   "elements of each sequence to show beside its length")
      ->capture_default_str();
  command->add_flag("--times", options->times, "put log_time_ns and publish_time_ns first");
  command->callback([&chosen, file, options, format] {
    chosen = [file, options] {
      const mcap::Reader reader(*file);
      warn_if_cut(reader, std::cerr);
      try {
        write_csv(reader, *options, std::cout);
      } catch (const std::invalid_argument& error) {
        std::cerr << "scarab-log: " << error.what() << '\n';
        return kBadUsage;
      }
      return kSuccess;
    };
  });
}

void add_diff(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand(
      "diff", "whether two logs hold the same samples, wall-clock stamps aside");
  command->alias("compare");
  command->footer(
      "Exit code: 0 equal, 1 different, 2 nothing could be compared.\n"
      "Example: scarab-log diff a.mcap b.mcap --topic scarab/behaviour");
  auto arguments = std::make_shared<CompareArguments>();
  add_file(*command, "a", arguments->a, "one log");
  add_file(*command, "b", arguments->b, "the other");
  command->add_option("--topic", arguments->topics,
                      "a topic to compare; repeatable; the chain's if none");
  command->callback([&chosen, arguments] {
    chosen = [arguments] {
      try {
        return compare(*arguments);
      } catch (const mcap::Error& error) {
        std::cerr << "scarab-log: " << error.what() << '\n';
        return kBadUsage;  // like diff: trouble is not a difference
      }
    };
  });
}

void add_recover(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand(
      "recover", "make a whole file of a cut one: the log of a recorder that was killed");
  command->footer("Example: scarab-log recover trial.mcap.active trial.mcap");
  auto from = std::make_shared<std::string>();
  auto to = std::make_shared<std::string>();
  add_file(*command, "in", *from, "the cut log");
  command->add_option("out", *to, "the new file")->type_name("FILE")->required();
  command->callback([&chosen, from, to] {
    chosen = [from, to] {
      const mcap::Recovery recovery = mcap::recover(*from, *to);
      std::cout << *to << ": " << recovery.messages << " messages of " << recovery.chunks
                << " chunks, " << recovery.attachments << " attachments; " << recovery.bytes_lost
                << " bytes at the end were no whole record\n";
      if (!recovery.damage.empty()) std::cout << "left out: " << recovery.damage << '\n';
      return kSuccess;
    };
  });
}

void add_attachments(CLI::App& app, Command& chosen) {
  auto* command = app.add_subcommand("attachments", "list the attached files, or write them out");
  auto file = std::make_shared<std::string>();
  auto folder = std::make_shared<std::string>();
  add_file(*command, "file", *file, "the log");
  command->add_option("--extract", *folder, "write them below this folder")->type_name("DIR");
  command->callback([&chosen, file, folder] {
    chosen = [file, folder] {
      const mcap::Reader reader(*file);
      if (folder->empty()) {
        for (const auto& attachment : reader.summary().attachments) {
          std::cout << attachment.name << '\n';
        }
      } else {
        for (const auto& path : extract_attachments(reader, *folder)) {
          std::cout << path.string() << '\n';
        }
      }
      return kSuccess;
    };
  });
}

}  // namespace scarab::log
