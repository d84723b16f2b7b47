#include <iostream>

#include "common/bus/raw_reader.hpp"
#include "common/bus/sample_text.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/commands.hpp"
#include "tools/topic/session.hpp"

namespace scarab::topic {

int echo(const runtime::BusOptions& bus_options, const EchoOptions& options) {
  Session session(bus_options);
  const auto writers = session.wait_for_writers(options.topic, options.timeout);
  if (writers.empty()) return runtime::kExitInterrupted;
  const bus::TopicType type = session.discovery().type_of(writers.front(), options.timeout);
  const bus::TypeModel model = bus::TypeModel::from_descriptor(*type);
  bus::RawReader reader(session.participant(), writers, type);
  session.waitset().attach(reader);

  std::uint64_t printed = 0;
  const auto wanted = [&] { return options.count == 0 || printed < options.count; };
  while (wanted() && !session.interrupted()) {
    session.waitset().wait(std::chrono::seconds(1));
    session.discovery().update();
    reader.take([&](const bus::RawSample& sample) {
      if (!wanted()) return;
      ++printed;
      if (options.json) {
        std::cout << bus::json_text(model, sample.cdr) << '\n';
      } else {
        std::cout << bus::yaml_text(model, sample.cdr) << "---\n";
      }
    });
    std::cout.flush();
  }
  return wanted() && options.count != 0 ? runtime::kExitInterrupted : runtime::kExitSuccess;
}

}  // namespace scarab::topic
