#include <headerPubSubTypes.h>

#include "tests/interop/fastdds/options.hpp"
#include "tests/interop/fastdds/stop_signal.hpp"
#include "tests/interop/fastdds/writer.hpp"

using namespace scarab::fastdds;

namespace {

/// A type that Scarab does not know: by its name, and that is all Fast DDS tells of it.
class WeatherSupport : public scarab::HeaderPubSubType {
 public:
  WeatherSupport() { setName("meadow::Weather"); }
};

constexpr Topic<WeatherSupport> kWeather{"meadow/weather", Profile::kState};
constexpr std::chrono::milliseconds kPoll{20};

}  // namespace

int main(int argc, char** argv) {
  const Program program{"fastdds-stranger", "Writes one sample of a type of its own, and stays."};
  return run_program(program, argc, argv, [](const Options& options) {
    StopSignal stop;
    Node node(options.domain, options.address(), {"meadow", options.instance});
    Writer<WeatherSupport> writer(node, kWeather);
    scarab::Header sample;
    writer.write(sample);
    while (!stop.requested()) node.wait(kPoll);
  });
}
