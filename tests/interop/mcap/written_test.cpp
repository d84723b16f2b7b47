/// A log of the real recorder, written by real Cyclone writers, read by MCAP and IDL readers of
/// others (npm).
#include <fstream>

#include "common/bus/sample_fields.hpp"
#include "tests/integration/logger/fixture.hpp"
#include "tests/integration/logger/meadow_topic.hpp"
#include "tests/interop/mcap/json_array.hpp"
#include "tests/interop/mcap/npm_readers.hpp"

namespace scarab::logger::test {
namespace {

using scarab::test::json_array;

constexpr std::uint32_t kTicks = 120;

class McapInterop : public LoggerTest {
 protected:
  /// Exit code and output of the reader.
  std::pair<int, std::string> read(const std::filesystem::path& log) const {
    const auto result = readers_.run("compare_expected.mjs", {log, folder_ / "expected.json"});
    return {result.exit_code, result.out + result.err};
  }

  void publish(bus::Writer<scarab_RobotState>& states, bus::Writer<scarab_WorldState>& worlds,
               bus::Writer<scarab_Behaviour>& behaviours, bus::Writer<meadow_Weather>& weather) {
    std::string state_json;
    std::string world_json;
    std::string behaviour_json;
    std::string weather_json;
    for (std::uint32_t tick = 0; tick < kTicks; ++tick) {
      ASSERT_TRUE(eventually([&] { return may_write(1, tick); }));
      const std::string comma = tick > 0 ? "," : "";
      state_json += comma + write_state(states, tick);
      world_json += comma + write_world(worlds, tick);
      behaviour_json += comma + write_behaviour(behaviours, tick);
      weather_json += comma + write_weather(weather, tick);
    }
    std::ofstream expected(folder_ / "expected.json");
    expected << R"({"scarab/robot_state":[)" << state_json << R"(],"scarab/world_state":[)"
             << world_json << R"(],"scarab/behaviour":[)" << behaviour_json
             << R"(],"meadow/weather":[)" << weather_json << "]}";
  }

  // Each writes a sample and returns it, or part of it, as JSON; 64-bit numbers as text.
  static std::string header_json(const scarab_Header& header) {
    return R"("header":{"trial":)" + std::to_string(header.trial) + R"(,"tick":)" +
           std::to_string(header.tick) + R"(,"sim_time_ns":")" +
           std::to_string(header.sim_time_ns) + R"(","stamp_ns":")" +
           std::to_string(header.stamp_ns) + R"("})";
  }

  std::string write_state(bus::Writer<scarab_RobotState>& writer, std::uint32_t tick) {
    scarab_RobotState state = robot_state(1, tick);
    state.phase = scarab_PHASE_SAFE_STOP;
    state.position_source[18] = scarab_SOURCE_COMMANDED;
    state.inclination_rad[1] = 1.0 / (tick + 3.0);
    writer.write(state);
    return "{" + header_json(state.header) + R"(,"phase":1,"position_rad":)" +
           json_array(state.position_rad) + R"(,"position_source":)" +
           json_array(state.position_source) + R"(,"inclination_rad":)" +
           json_array(state.inclination_rad) + "}";
  }

  static std::string write_world(bus::Writer<scarab_WorldState>& writer, std::uint32_t tick) {
    scarab_WorldState world{};
    world.header = {1, tick, tick * 20'000'000LL, 7};
    std::vector<scarab_Contact> contacts(tick % 4);
    std::string contacts_json;
    for (scarab_Contact& contact : contacts) {
      contact.solid_a = scarab_SOLID_FOOT;
      contact.leg_a = static_cast<std::uint16_t>(tick % 6);
      contact.force_n[2] = 0.1 * tick;
      contacts_json += (contacts_json.empty() ? "" : ",") +
                       std::string(R"({"solid_a":7,"leg_a":)") + std::to_string(contact.leg_a) +
                       R"(,"solid_b":0,"force_n":)" + json_array(contact.force_n) + "}";
    }
    bus::borrow(world.contacts, contacts);
    world.obstacle_present = tick % 2 == 1;
    world.object.position_m[0] = -0.001 * tick;
    bus::assign(world.verdict_reason, "still open");
    writer.write(world);
    return "{" + header_json(world.header) + R"(,"contacts":[)" + contacts_json +
           R"(],"obstacle_present":)" + (world.obstacle_present ? "true" : "false") +
           R"(,"object":{"position_m":)" + json_array(world.object.position_m) +
           R"(},"verdict_reason":"still open"})";
  }

  static std::string write_behaviour(bus::Writer<scarab_Behaviour>& writer, std::uint32_t tick) {
    scarab_Behaviour behaviour{};
    behaviour.header = {1, tick, 0, -1};
    behaviour.mode = scarab_MODE_HARD_PUSH;
    behaviour.inputs[3] = -0.5;
    behaviour.hind_override = true;
    bus::assign(behaviour.reason, "käfer " + std::to_string(tick));
    writer.write(behaviour);
    return "{" + header_json(behaviour.header) + R"(,"mode":6,"inputs":)" +
           json_array(behaviour.inputs) + R"(,"hind_override":true,"reason":"käfer )" +
           std::to_string(tick) + R"("})";
  }

  static std::string write_weather(bus::Writer<meadow_Weather>& writer, std::uint32_t tick) {
    meadow_Weather weather{};
    weather.station = -4;
    weather.sky = meadow_SKY_CLOUDY;
    weather.wind_m_s[0] = 1e-300 * tick;
    std::vector<float> drops(tick % 9, 0.25F);
    bus::borrow(weather.drops, drops);
    writer.write(weather);
    std::string drops_json;
    for (std::size_t i = 0; i < drops.size(); ++i) drops_json += i > 0 ? ",0.25" : "0.25";
    return R"({"station":-4,"sky":1,"wind_m_s":)" + json_array(weather.wind_m_s) +
           R"(,"remark":"","drops":[)" + drops_json + "]}";
  }

  scarab::test::NpmReaders readers_;
};

TEST_F(McapInterop, ReadersOfOthersAgreeWithWhatWasSent) {
  mcap::test::write_file(folder_ / "small.yaml", std::string_view("chunk_size_kib: 32\n"));
  auto logger =
      start({"--output", (folder_ / "x.mcap").string(), "--config",
             (folder_ / "small.yaml").string(), "--attach", (folder_ / "small.yaml").string()});
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  bus::Writer<scarab_WorldState> worlds(participant_, bus::kWorldState);
  bus::Writer<scarab_Behaviour> behaviours(participant_, bus::kBehaviour);
  bus::Writer<meadow_Weather> weather(participant_, bus::kMeadowWeather);
  bus::Writer<scarab_RobotState> sensors(participant_, bus::kRobotSensors);
  // Both sides have to have matched, as each service checks for its own.
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  ASSERT_TRUE(wait_for_reader(worlds)) << logger->output();
  ASSERT_TRUE(wait_for_reader(behaviours)) << logger->output();
  ASSERT_TRUE(wait_for_reader(weather)) << logger->output();
  ASSERT_TRUE(wait_until_ready(1)) << logger->output();
  // A volatile writer's first sample may be lost on a reader that has not seen its heartbeat yet
  // (logger/README.md).
  worlds.write({});
  weather.write({});
  publish(states, worlds, behaviours, weather);
  if (HasFatalFailure()) return;
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == kTicks - 1; }));
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();

  const auto [code, output] = read(folder_ / "x.mcap");
  EXPECT_EQ(code, 0) << output;
  EXPECT_THAT(output, testing::HasSubstr("480 compared with what was sent"));
  std::cout << output;

  // The readers are not blind: one flipped bit in the last chunk, and they refuse.
  mcap::Bytes bytes = mcap::test::read_file(folder_ / "x.mcap");
  const mcap::Reader reader(folder_ / "x.mcap");
  const mcap::ChunkIndex& chunk = reader.summary().chunks.back();
  bytes.at(chunk.offset + chunk.length - chunk.compressed_size / 2) ^= 0x04U;
  mcap::test::write_file(folder_ / "flipped.mcap", bytes);
  EXPECT_EQ(read(folder_ / "flipped.mcap").first, 1);
}

}  // namespace
}  // namespace scarab::logger::test
