#include <atomic>
#include <csignal>
#include <regex>
#include <thread>

#include "common/bus/clock.hpp"
#include "tests/integration/topic/topic_tool.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;

struct Measure : TopicTool {
  /// A number of a line of JSON.
  static double number(const std::string& json, const std::string& key) {
    std::smatch found;
    const std::regex pattern("\"" + key + "\": ([-0-9.e+]+)");
    return std::regex_search(json, found, pattern) ? std::stod(found[1]) : -1.0;
  }

  AnyWriter writer_{plant_, "a", bus::descriptor<scarab_JointCommand>(), kept()};
  std::atomic<bool> done_{false};
  // 100 Hz; each sample says of itself that it is 5 s old.
  std::thread thread_{[this] {
    for (auto next = std::chrono::steady_clock::now(); !done_;
         next += std::chrono::milliseconds(10)) {
      scarab_JointCommand sample = joint_command(1);
      sample.header.stamp_ns = bus::now_ns() - 5'000'000'000;
      writer_.write(&sample);
      std::this_thread::sleep_until(next);
    }
  }};

  void TearDown() override {
    done_ = true;
    thread_.join();
  }
};

TEST_F(Measure, TellsRateAndIntervals) {
  const Finished hz = topic({"hz", "a", "-n", "2", "--json"});
  EXPECT_EQ(hz.exit_code, 0) << hz.err;
  const std::string line = hz.out.substr(hz.out.find('\n') + 1);
  EXPECT_NEAR(number(line, "rate_hz"), 100.0, 10.0) << line;
  EXPECT_NEAR(number(line, "interval_mean_s"), 0.01, 0.001) << line;
  EXPECT_LE(number(line, "interval_min_s"), number(line, "interval_mean_s"));
  EXPECT_GE(number(line, "interval_max_s"), number(line, "interval_mean_s"));
  EXPECT_GE(number(line, "interval_stddev_s"), 0.0);
  const Finished table = topic({"hz", "a", "-n", "1"});
  EXPECT_THAT(table.out, testing::StartsWith(
                             "      rate  interval                                 samples\n"
                             "        Hz   mean ms    min ms    max ms stddev ms          \n"));
}

TEST_F(Measure, TellsBytes) {
  const Finished bw = topic({"bw", "a", "-n", "1", "--json"});
  EXPECT_EQ(bw.exit_code, 0) << bw.err;
  const scarab_JointCommand sample{};
  const auto size = static_cast<double>(bus::encode(sample).size());
  EXPECT_EQ(number(bw.out, "size_min_bytes"), size) << bw.out;
  EXPECT_EQ(number(bw.out, "size_max_bytes"), size);
  EXPECT_NEAR(number(bw.out, "bytes_per_s"), number(bw.out, "samples_per_s") * size, 1.0);
  EXPECT_NEAR(number(bw.out, "samples_per_s"), 100.0, 15.0);
}

TEST_F(Measure, TellsHowOldSamplesAre) {
  const Finished delay = topic({"delay", "a", "-n", "1", "--json"});
  EXPECT_EQ(delay.exit_code, 0) << delay.err;
  EXPECT_GT(number(delay.out, "delay_min_s"), 0.0) << delay.out;
  EXPECT_LT(number(delay.out, "delay_p50_s"), 1.0);
  EXPECT_LE(number(delay.out, "delay_p50_s"), number(delay.out, "delay_p99_s"));
  EXPECT_LE(number(delay.out, "delay_p99_s"), number(delay.out, "delay_max_s"));
  const Finished stamp = topic({"delay", "a", "-n", "1", "--json", "--field", "header.stamp_ns"});
  EXPECT_GT(number(stamp.out, "delay_min_s"), 5.0) << stamp.out;
  EXPECT_LT(number(stamp.out, "delay_p50_s"), 6.0) << stamp.out;
  expect_refused(2, {"delay", "a", "--field", "kind"}, "--field: kind is no whole number");
  expect_refused(2, {"delay", "a", "--field", "header.tick"}, "--field: header.tick is no time");
  expect_refused(2, {"delay", "a", "--field", "header"}, "no member sec in scarab::Header");
}

TEST_F(Measure, EndsAtCtrlC) {
  ChildProcess endless = start_topic({"hz", "a"});
  ChildProcess counted = start_topic({"hz", "a", "-n", "100"});
  ASSERT_TRUE(eventually([&] {
    return endless.out().find("samples") != std::string::npos &&
           counted.out().find("samples") != std::string::npos;
  }));
  endless.signal(SIGINT);
  counted.signal(SIGINT);
  EXPECT_EQ(endless.wait(kPatience), 0);
  EXPECT_EQ(counted.wait(kPatience), 130);
}

TEST_F(Measure, WantsATopicThatIsWritten) {
  for (const char* verb : {"hz", "bw", "delay"}) {
    expect_refused(4, {verb, "b", "--timeout", "0.3"}, "no topic b in domain 0");
    expect_refused(2, {verb, "a", "--window", "0"}, "--window");
  }
}

TEST_F(Measure, WaitsForARate) {
  EXPECT_EQ(topic({"wait", "a", "--hz", "80", "--timeout", "15"}).exit_code, 0);
  expect_refused(3, {"wait", "a", "--hz", "1000", "--timeout", "1"}, "Hz of 1000 within 1 s");
}

}  // namespace
}  // namespace scarab::test
