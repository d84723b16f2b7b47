/// Recorders killed at random moments of a flood: what they leave behind, and what is lost.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <random>

#include "common/mcap/recover.hpp"
#include "tests/integration/logger/chunk_count.hpp"
#include "tests/integration/logger/fixture.hpp"
#include "tests/integration/logger/flood.hpp"

namespace scarab::logger::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kKills = 100;
constexpr std::size_t kAtOnce = 10;
constexpr double kMostLost = 1.0;  // s of wall time

/// A recorder from its start to its end by SIGKILL.
class Victim {
 public:
  Victim(const std::vector<std::string>& command, std::filesystem::path output,
         std::chrono::microseconds life)
      : output_(std::move(output)), life_(life), process_(command, output_.string() + ".log") {}

  /// Kills it when its life, which begins when it records all topics, is over. True once it has.
  bool kill_if_due() {
    if (killed_ns_ > 0) return true;
    if (born_ns_ == 0) {
      if (!records_all()) return false;
      born_ns_ = bus::now_ns();
      end_ = Clock::now() + life_;
    }
    if (Clock::now() < end_) return false;
    before_ = count_chunks(active());
    killed_ns_ = bus::now_ns();
    process_.kill();
    return true;
  }

  std::filesystem::path active() const { return output_.string() + ".active"; }
  const std::filesystem::path& output() const { return output_; }
  /// What its file held just before.
  const ChunkCount& before() const { return before_; }
  std::int64_t born_ns() const { return born_ns_; }
  std::int64_t killed_ns() const { return killed_ns_; }
  std::string words() const { return process_.output(); }

 private:
  bool records_all() const {
    const std::string said = process_.output();
    std::size_t topics = 0;
    for (auto at = said.find("records flood/"); at != std::string::npos;
         at = said.find("records flood/", at + 1)) {
      ++topics;
    }
    return topics == Flood::kTopics;
  }

  std::filesystem::path output_;
  std::chrono::microseconds life_;
  scarab::test::ChildProcess process_;
  std::int64_t born_ns_ = 0;
  Clock::time_point end_;
  ChunkCount before_;
  std::int64_t killed_ns_ = 0;
};

/// What a log has of one topic.
struct Recorded {
  std::uint64_t count = 0;
  std::uint32_t last_number = 0;
  std::int64_t last_stamp_ns = 0;
};

/// Readings of each topic of the flood; fails where one is missing between others, or changed.
std::map<std::string, Recorded> read_flood(const std::filesystem::path& path) {
  std::map<std::string, Recorded> topics;
  mcap::Reader(path).for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
    if (channel.topic.rfind("flood/", 0) != 0) return;
    const meadow_Reading reading = decode_reading(message.data);
    Recorded& recorded = topics[channel.topic];
    if (recorded.count++ > 0) {
      EXPECT_EQ(reading.number, recorded.last_number + 1) << path << ": gap in " << channel.topic;
    }
    recorded.last_number = reading.number;
    recorded.last_stamp_ns = reading.stamp_ns;
  });
  return topics;
}

class Kills : public LoggerTest {
 protected:
  /// Some close a chunk every few samples, so that many kills hit a write; others as by default.
  std::vector<std::string> command(const std::filesystem::path& output, const std::string& tag,
                                   bool small_chunks) const {
    std::vector<std::string> words = {SCARAB_BIN_DIR "/scarab-logger", "--tag", tag, "--output",
                                      output};
    if (small_chunks) words.insert(words.end(), {"--config", folder_ / "small.yaml"});
    return words;
  }

  /// Kills kAtOnce recorders of one flood.
  void kill_some(std::size_t round, std::mt19937_64& generator) {
    constexpr std::int64_t kLongestLifeUs = 1'500'000;
    const std::string tag = tag_ + "-" + std::to_string(round);
    scarab::test::ChildProcess flood({SCARAB_BIN_DIR "/logger_flood", tag}, folder_ / "flood");
    std::vector<Victim> victims;
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      const auto output =
          folder_ / ("x-" + std::to_string(round) + "-" + std::to_string(i) + ".mcap");
      const std::chrono::microseconds life(
          std::uniform_int_distribution<std::int64_t>(0, kLongestLifeUs)(generator));
      victims.emplace_back(command(output, tag, i % 2 == 0), output, life);
    }
    std::size_t dead = 0;
    const bool all_dead = eventually([&] {
      dead = static_cast<std::size_t>(std::count_if(
          victims.begin(), victims.end(), [](Victim& victim) { return victim.kill_if_due(); }));
      return dead == victims.size();
    });
    ASSERT_TRUE(all_dead) << dead << " of " << victims.size() << " recorded\n"
                          << victims.front().words() << flood.output();
    flood.kill();
    for (const Victim& victim : victims) examine(victim);
  }

  void examine(const Victim& victim) {
    const ChunkCount left = count_chunks(victim.active());
    const mcap::Reader reader(victim.active());
    EXPECT_FALSE(reader.closed());
    EXPECT_GE(left.messages, victim.before().messages);
    EXPECT_EQ(reader.summary().statistics.chunk_count, left.chunks);
    // Of the last chunk the index may be cut, which the reader does without.
    EXPECT_GE(reader.summary().statistics.message_count, left.messages);
    mcap::recover(victim.active(), victim.output());
    const mcap::Reader mended(victim.output());
    EXPECT_TRUE(mended.closed());
    EXPECT_EQ(mended.summary().statistics.message_count, reader.summary().statistics.message_count);

    auto topics = read_flood(victim.output());
    if (reader.bytes_lost() > 0) ++cut_;
    std::int64_t recorded_until = victim.killed_ns();
    for (const auto* topic : {"flood/fast", "flood/kept", "flood/slow"}) {
      recorded_until =
          std::min(recorded_until, std::max(victim.born_ns(), topics[topic].last_stamp_ns));
    }
    lost_s_.push_back(1e-9 * static_cast<double>(victim.killed_ns() - recorded_until));
    EXPECT_LE(lost_s_.back(), kMostLost) << victim.active() << "\n" << victim.words();
    std::filesystem::remove(victim.active());
    std::filesystem::remove(victim.output());
  }

  std::vector<double> lost_s_;
  std::size_t cut_ = 0;  // files that end within a record
};

TEST_F(Kills, EveryClosedChunkIsReadBackAndAtMostASecondIsLost) {
  const char* given = std::getenv("SCARAB_TEST_SEED");
  const std::uint64_t seed =
      given != nullptr ? std::strtoull(given, nullptr, 10) : std::random_device{}();
  std::cout << "SCARAB_TEST_SEED=" << seed << " repeats these kills\n";
  std::mt19937_64 generator(seed);
  mcap::test::write_file(folder_ / "small.yaml", std::string_view("chunk_size_kib: 4\n"));
  for (std::size_t round = 0; round * kAtOnce < kKills; ++round) {
    kill_some(round, generator);
    ASSERT_FALSE(HasFatalFailure()) << "round " << round;
  }
  std::sort(lost_s_.begin(), lost_s_.end());
  ASSERT_EQ(lost_s_.size(), kKills);
  std::cout << kKills << " kills, " << cut_ << " within a write; lost s: least " << lost_s_.front();
  for (const std::size_t percent : {25U, 50U, 75U, 95U}) {
    std::cout << ", " << percent << " % " << lost_s_[kKills * percent / 100];
  }
  std::cout << ", most " << lost_s_.back() << "\n";
}

}  // namespace
}  // namespace scarab::logger::test
