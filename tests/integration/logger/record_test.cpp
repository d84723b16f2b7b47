/// The recorder as a process: what it records, what it says of itself, how it ends.
#include "common/bus/clock.hpp"
#include "common/bus/sample_fields.hpp"
#include "tests/integration/logger/fixture.hpp"
#include "tests/integration/logger/meadow_topic.hpp"

namespace scarab::logger::test {
namespace {

using testing::HasSubstr;

class Record : public LoggerTest {};

constexpr std::uint8_t kUncountedStation = 99;

/// DDS keeps the order of samples within an instance, so a keyed topic is compared key by key.
std::map<std::uint8_t, std::vector<mcap::Bytes>> by_station(const std::vector<mcap::Bytes>& all) {
  std::map<std::uint8_t, std::vector<mcap::Bytes>> grouped;
  for (const mcap::Bytes& bytes : all) grouped[bytes.at(4)].push_back(bytes);
  grouped.erase(kUncountedStation);
  return grouped;
}

meadow_Weather weather_of(std::int32_t station) {
  meadow_Weather weather{};
  weather.station = station;
  return weather;
}

TEST_F(Record, EverySampleOfEveryTopicWithItsIdlByteForByte) {
  auto logger = start({"--output", (folder_ / "x.mcap").string(), "--expect", "plant=1"});
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  bus::Writer<scarab_RobotState> sensors(participant_, bus::kRobotSensors);
  bus::Writer<scarab_WorldState> worlds(participant_, bus::kWorldState);
  bus::Writer<meadow_Weather> weather(participant_, bus::kMeadowWeather);
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  ASSERT_TRUE(wait_for_reader(weather)) << logger->output();
  ASSERT_TRUE(wait_until_ready(1)) << logger->output();
  // A volatile writer's first sample may be lost on a reader that has not seen its heartbeat yet
  // (logger/README.md).
  weather.write(weather_of(kUncountedStation));
  std::vector<float> drops{1.5F, 2.5F};
  for (std::uint32_t tick = 0; tick < 300; ++tick) {
    ASSERT_TRUE(eventually([&] { return may_write(1, tick); }));
    write(states, robot_state(1, tick));
    meadow_Weather w = weather_of(static_cast<std::int32_t>(tick % 5));
    w.sky = meadow_SKY_CLOUDY;
    w.wind_m_s[1] = 0.5 * tick;
    bus::assign(w.remark, "gust " + std::to_string(tick));
    bus::borrow(w.drops, drops);
    write(weather, w);
  }
  // Nothing waits for the recorder here: what is on its way when it is told to stop is recorded
  // too.
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();

  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.mcap.active"));
  const mcap::Reader reader(folder_ / "x.mcap");
  EXPECT_TRUE(reader.closed());
  const Samples recorded = read_samples(folder_ / "x.mcap");
  EXPECT_TRUE(recorded.at("scarab/robot_state") == sent_.at("scarab/robot_state"))
      << recorded.at("scarab/robot_state").size() << " of " << sent_.at("scarab/robot_state").size()
      << "\n"
      << logger->output();
  EXPECT_TRUE(by_station(recorded.at("meadow/weather")) == by_station(sent_.at("meadow/weather")));
  EXPECT_GT(recorded.at("scarab/service_status").size(), 10U) << "its own status is a topic too";
  for (const auto& [id, channel] : reader.summary().channels) {
    EXPECT_EQ(channel.message_encoding, "cdr");
    const mcap::Schema& schema = reader.summary().schemas.at(channel.schema_id);
    EXPECT_EQ(schema.encoding, "omgidl");
    if (channel.topic == "meadow/weather") {
      EXPECT_EQ(schema.name, "meadow::Weather");
      EXPECT_THAT(schema.data, HasSubstr("struct Weather"));
      EXPECT_THAT(schema.data, HasSubstr("SKY_CLOUDY"));
    }
  }
}

TEST_F(Record, TimesAreThoseOfTheWriterAndOfTheReception) {
  auto logger = start({"--output", (folder_ / "x.mcap").string()});
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  ASSERT_TRUE(wait_for_reader(states)) << logger->output();
  const auto before = static_cast<std::uint64_t>(bus::now_ns());
  write(states, robot_state(1, 5));
  const auto after = static_cast<std::uint64_t>(bus::now_ns());
  ASSERT_TRUE(eventually([&] { return status().recorded_tick == 5; })) << logger->output();
  logger->signal(SIGINT);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();
  const auto end = static_cast<std::uint64_t>(bus::now_ns());
  std::size_t count = 0;
  mcap::Reader(folder_ / "x.mcap")
      .for_each(
          [&](const mcap::Channel&, const mcap::Message& message) {
            EXPECT_GE(message.publish_time_ns, before);
            EXPECT_LE(message.publish_time_ns, after);
            EXPECT_GE(message.log_time_ns, message.publish_time_ns);
            EXPECT_LE(message.log_time_ns, end);
            ++count;
          },
          {"scarab/robot_state"});
  EXPECT_EQ(count, 1U);
}

TEST_F(Record, SaysReadyOnlyWhenEveryExpectedWriterIsMatched) {
  auto logger = start({"--output", (folder_ / "x.mcap").string(), "--expect",
                       "plant=1,supervisor=1,premotor=1,logger=1"});
  scarab_Trial trial{};
  trial.header.trial = 3;
  trials_.write(trial);
  bus::Writer<scarab_RobotState> states(participant_, bus::kRobotState);
  bus::Writer<scarab_RobotState> sensors(participant_, bus::kRobotSensors);
  bus::Writer<scarab_WorldState> world(participant_, bus::kWorldState);
  bus::Participant supervisor(options("supervisor"));
  bus::Writer<scarab_Behaviour> behaviour(supervisor, bus::kBehaviour);
  bus::Participant premotor(options("premotor"));
  bus::Writer<scarab_JointCommand> commands(premotor, bus::kJointCommand);

  // After a second it says whom it waits for: the one writer that is not there.
  ASSERT_TRUE(eventually([&] {
    return status().health == scarab_HEALTH_WAITING &&
           std::string(status().message) == "waits for premotor/0 to write scarab/neural_activity";
  })) << status().message;
  EXPECT_EQ(status().ready_trial, 0U);

  bus::Writer<scarab_NeuralActivity> activity(premotor, bus::kNeuralActivity);
  ASSERT_TRUE(eventually([&] { return status().ready_trial == 3; })) << status().message;
  EXPECT_EQ(status().health, scarab_HEALTH_OK);
  EXPECT_EQ(status().lifecycle, scarab_LIFECYCLE_ACTIVE);
  logger->signal(SIGTERM);
  EXPECT_EQ(logger->wait(20s), 0);
}

TEST_F(Record, AttachesTheNamedFilesAndTheRunsConfiguration) {
  std::filesystem::create_directories(folder_ / "run" / "config");
  mcap::test::write_file(folder_ / "run" / "config" / "plant.yaml",
                         std::string_view("step_s: 1\n"));
  mcap::test::write_file(folder_ / "note.txt", std::string_view("hello"));
  auto logger =
      start({"--run-dir", (folder_ / "run").string(), "--attach", (folder_ / "note.txt").string()});
  ASSERT_TRUE(eventually([&] { return status().lifecycle == scarab_LIFECYCLE_INACTIVE; }));
  logger->signal(SIGTERM);
  ASSERT_EQ(logger->wait(20s), 0) << logger->output();
  const mcap::Reader reader(folder_ / "run" / "trial.mcap");
  std::map<std::string, std::string> attached;
  for (const auto& index : reader.summary().attachments) {
    const mcap::Attachment attachment = reader.attachment(index);
    attached[attachment.name] = std::string(attachment.data.begin(), attachment.data.end());
  }
  EXPECT_THAT(attached["config/logger.yaml"], HasSubstr("chunk_time_s: 0.5"));
  attached.erase("config/logger.yaml");
  EXPECT_EQ(attached, (std::map<std::string, std::string>{{"config/plant.yaml", "step_s: 1\n"},
                                                          {"note.txt", "hello"}}));
  const auto metadata = read_metadata(reader);
  EXPECT_EQ(metadata.at("scarab.recording").at("part"), "1");
  EXPECT_EQ(metadata.at("scarab.recording").count("version"), 1U);
  EXPECT_THAT(metadata.at("scarab.host").at("cyclone_dds"), HasSubstr("0.10"));
  EXPECT_THAT(metadata.at("scarab.host").at("kernel"), HasSubstr("Linux"));
  EXPECT_EQ(metadata.at("scarab.recorded").at("dropped"), "0");
}

TEST_F(Record, BadUsageStartsNothing) {
  const auto ends_with = [&](const std::vector<std::string>& arguments) {
    auto logger = start(arguments);
    const auto code = logger->wait(20s);
    const std::string output = logger->output();
    EXPECT_EQ(std::count(output.begin(), output.end(), '\n'), 1) << output;
    return std::make_pair(code, output);
  };
  EXPECT_EQ(ends_with({}).first, 2);
  for (const std::string attached : {"/absent", "/dev/zero", "/proc"}) {
    EXPECT_EQ(ends_with({"--output", (folder_ / "x.mcap").string(), "--attach", attached}).first,
              2);
  }
  EXPECT_EQ(ends_with({"--output", "/dev/null"}).first, 2);
  EXPECT_EQ(ends_with({"--output", (folder_ / "").string()}).first, 2);
  mcap::test::write_file(folder_ / "bad.yaml", std::string_view("chunk_tim_s: 1\n"));
  const auto [code, output] = ends_with(
      {"--output", (folder_ / "x.mcap").string(), "--config", (folder_ / "bad.yaml").string()});
  EXPECT_EQ(code, 2);
  EXPECT_THAT(output, HasSubstr("bad.yaml:1:1: chunk_tim_s: unknown key"));
  EXPECT_THAT(output, HasSubstr("chunk_time_s"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.mcap.active"));
  const auto nowhere = ends_with({"--output", "/nowhere/x.mcap"});
  EXPECT_EQ(nowhere.first, 1);
  EXPECT_THAT(nowhere.second, HasSubstr("/nowhere/x.mcap.active: No such file or directory"));
}

}  // namespace
}  // namespace scarab::logger::test
