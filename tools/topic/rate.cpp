#include <algorithm>
#include <iomanip>
#include <iostream>

#include "common/bus/raw_reader.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {

namespace {

using Clock = std::chrono::steady_clock;

/// What arrived since the last line.
struct Window {
  Clock::time_point begin = Clock::now();
  std::uint64_t samples = 0;
  std::uint64_t bytes = 0;

  void print() const {
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    std::cout << std::fixed << std::setprecision(1) << static_cast<double>(samples) / seconds
              << " Hz  " << static_cast<double>(bytes) / seconds / 1000.0 << " kB/s  " << samples
              << " samples in " << std::setprecision(2) << seconds << " s" << std::endl;
  }
};

}  // namespace

int rate(const runtime::BusOptions& bus_options, const EchoOptions& options) {
  Session session(bus_options);
  const auto writers = session.wait_for_writers(options.topic, options.timeout);
  if (writers.empty()) return runtime::kExitInterrupted;
  const bus::TopicType type = session.discovery().type_of(writers.front(), options.timeout);
  bus::RawReader reader(session.participant(), writers, type);
  session.waitset().attach(reader);

  constexpr std::chrono::seconds kLine{1};
  for (std::uint64_t line = 0; options.count == 0 || line < options.count; ++line) {
    Window window;
    while (Clock::now() < window.begin + kLine) {
      if (session.interrupted()) return runtime::kExitSuccess;
      session.waitset().wait(window.begin + kLine - Clock::now());
      session.discovery().update();
      reader.take([&](const bus::RawSample& sample) {
        ++window.samples;
        window.bytes += sample.cdr.size;
      });
    }
    window.print();
  }
  return runtime::kExitSuccess;
}

}  // namespace scarab::topic
