#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "common/runtime/program.hpp"
#include "tools/topic/command_options.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/line_input.hpp"
#include "tools/topic/publication.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {
namespace {

struct PubOptions {
  PublicationOptions publication;
  std::string value;
  std::optional<double> rate_hz;
  std::optional<std::uint64_t> count;
  bool once = false;
  double timeout_s = 5.0;
};

/// A value, and what an error in it calls it.
struct Source {
  std::string name;
  sample::WrittenValue value;
};

/// Of the command line, or of a file; not of standard input.
std::vector<Source> sources_of(const std::string& value) {
  if (value.front() != '@') return {{"value", read_value("value", value)}};
  const std::string file = value.substr(1);
  const std::string text = read_whole(file);
  std::vector<Source> out;
  DocumentSplitter splitter;
  const auto take = [&](const std::optional<std::string>& document) {
    if (document) out.push_back({file, read_value(file, *document)});
  };
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    take(splitter.add(text.substr(begin, end - begin)));
  }
  if (begin < text.size()) take(splitter.add(text.substr(begin)));
  take(splitter.finish());
  if (out.empty()) throw Failure(runtime::kExitBadUsage, file + ": there is no value in it");
  if (out.size() > 1) {
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].name += ", value " + std::to_string(i + 1);
    }
  }
  return out;
}

/// Waits between samples so that they leave at a rate.
class Pace {
 public:
  Pace(Session& session, const std::optional<double>& rate_hz) : session_(session) {
    if (rate_hz) {
      period_ = std::chrono::duration_cast<Clock::duration>(
          std::chrono::duration<double>(1.0 / *rate_hz));
    }
  }
  /// False: interrupted.
  bool wait() {
    if (first_) next_ = Clock::now();
    first_ = false;
    while (Clock::now() < next_ && !session_.interrupted()) session_.wait(next_);
    next_ += period_;
    return !session_.interrupted();
  }

 private:
  Session& session_;
  Clock::duration period_{0};
  Clock::time_point next_;
  bool first_ = true;
};

void report(Session& session, const std::vector<bus::Peer>& readers, std::uint64_t sent) {
  std::string names;
  for (const bus::Peer& peer : readers) names += (names.empty() ? ": " : ", ") + to_string(peer);
  session.output().write("published " + counted(sent, "sample") + " to " +
                         counted(readers.size(), "reader") + names + "\n");
  session.output().flush();
}

/// Returns how many were sent.
std::uint64_t send_values(Session& session, Publication& publication, const PubOptions& options) {
  const std::vector<Source> sources = sources_of(options.value);
  for (const Source& source : sources) publication.encode(source.name, source.value);
  publication.open();
  // Every value once; at a rate, again and again.
  const std::uint64_t most = options.count.value_or(
      options.rate_hz ? std::numeric_limits<std::uint64_t>::max() : sources.size());
  Pace pace(session, options.rate_hz);
  std::uint64_t sent = 0;
  for (; sent < most && pace.wait(); ++sent) {
    const Source& source = sources[sent % sources.size()];
    publication.write(publication.encode(source.name, source.value));  // `now` is another now
  }
  return sent;
}

std::uint64_t send_input(Session& session, Publication& publication, const PubOptions& options) {
  publication.open();
  Pace pace(session, options.rate_hz);
  DocumentSplitter splitter;
  std::uint64_t sent = 0;
  const auto wanted = [&] { return !options.count || sent < *options.count; };
  const auto send = [&](const std::optional<std::string>& document) {
    if (!document) return true;
    const std::string name = "standard input, value " + std::to_string(sent + 1);
    const sample::Bytes sample = publication.encode(name, read_value(name, *document));
    if (!pace.wait()) return false;
    publication.write(sample);
    ++sent;
    return wanted();
  };
  const bool ended = read_lines([&] { return session.interrupted(); },
                                [&](const std::string& line) { return send(splitter.add(line)); });
  if (ended && wanted()) send(splitter.finish());
  return sent;
}

int pub(const runtime::BusOptions& bus_options, const PubOptions& options) {
  const bool from_input = options.value == "-";
  if (!from_input) sources_of(options.value);  // what cannot be read is refused before all else
  Session session(bus_options);
  Publication publication(session, options.publication);
  const std::uint64_t sent = from_input ? send_input(session, publication, options)
                                        : send_values(session, publication, options);
  if (session.interrupted() && (options.count || !options.rate_hz)) throw Interrupted{};
  publication.finish();
  report(session, publication.readers(), sent);
  return runtime::kExitSuccess;
}

}  // namespace

void add_pub(CLI::App& app, Choice& choice) {
  const auto options = std::make_shared<PubOptions>();
  CLI::App& command = *app.add_subcommand("pub", "publish a topic from YAML or JSON");
  add_topic(command, options->publication.topic);
  command
      .add_option(
          "value", options->value,
          "a YAML or JSON value; @FILE: those in a file; -: those on standard input as they "
          "come (YAML documents ended by ---, or JSON)")
      ->required()
      ->check(CLI::Validator([](const std::string& text) { return text.empty() ? "is empty" : ""; },
                             ""));
  command.add_option("--type", options->publication.type,
                     "the type's name, where nobody has the topic yet");
  command.add_option("--rate", options->rate_hz, "publish so often, until Ctrl-C or -n")
      ->check(CLI::Range(0.001, 100000.0).description(""))
      ->type_name("HZ");
  add_count(command, options->count, "end after so many samples");
  command.add_flag("--once", options->once, "one sample, like -n 1")->excludes("--count");
  command
      .add_option("--wait", options->publication.readers,
                  "readers to wait for before the first sample")
      ->capture_default_str()
      ->type_name("N");
  add_seconds(command, "--timeout", options->timeout_s,
              "s to wait for the topic and its readers, and for the acknowledgement");
  command.footer(
      "Members that are left out are zero. Names, ranges, enum values and bounds are checked "
      "before\n"
      "anything is sent. The word now is the time, for 64-bit integers (header.stamp_ns) and for\n"
      "stamps of sec and nanosec. The QoS is that of the topic's writers or profile, made to "
      "match\n"
      "the readers there are.\n"
      "Examples:\n"
      "  scarab-topic pub scarab/operator '{header: {stamp_ns: now}, command: OPERATOR_PAUSE}'\n"
      "  scarab-topic pub rt/cmd_vel '{linear: {x: 0.2}}' --rate 10 -n 50\n"
      "  scarab-topic echo a --json | scarab-topic pub b - --type scarab::RobotState\n"
      "Exit codes: 0 done, 1 failed, 2 bad usage or value, 3 not enough readers in time, 4 no "
      "such\n"
      "topic, 5 type unknown, 130 interrupted before all was sent.");
  command.callback([&choice, options] {
    if (options->once) options->count = 1;
    options->publication.timeout = milliseconds(options->timeout_s);
    choice.run = [&choice, options] { return pub(choice.bus, *options); };
  });
}

}  // namespace scarab::topic
