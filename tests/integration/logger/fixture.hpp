#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <memory>
#include <thread>

#include "common/bus/cdr.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/topics.hpp"
#include "common/bus/writer.hpp"
#include "common/mcap/reader.hpp"
#include "tests/support/child_process.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::logger::test {

using namespace std::chrono_literals;

/// Waits until `condition` holds; false after `limit`.
template <class Condition>
bool eventually(Condition&& condition, std::chrono::milliseconds limit = 20s) {
  const auto end = std::chrono::steady_clock::now() + limit;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(1ms);
  }
  return true;
}

/// The samples of each topic in a log, as bytes.
using Samples = std::map<std::string, std::vector<mcap::Bytes>>;

inline Samples read_samples(const std::filesystem::path& path) {
  Samples samples;
  const mcap::Reader reader(path);
  reader.for_each([&](const mcap::Channel& channel, const mcap::Message& message) {
    samples[channel.topic].push_back(mcap::copy_of(message.data));
  });
  return samples;
}

/// The metadata records of a log by name; the last of each.
inline std::map<std::string, std::map<std::string, std::string>> read_metadata(
    const mcap::Reader& reader) {
  std::map<std::string, std::map<std::string, std::string>> metadata;
  for (const auto& index : reader.summary().metadata) {
    metadata[index.name] = reader.metadata(index).entries;
  }
  return metadata;
}

/// The real recorder and a participant that plays the stack around it, alone on a discovery tag.
class LoggerTest : public testing::Test {
 protected:
  std::unique_ptr<scarab::test::ChildProcess> start(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {SCARAB_BIN_DIR "/scarab-logger", "--tag", tag_});
    const std::string log = "logger-" + std::to_string(++started_) + ".log";
    return std::make_unique<scarab::test::ChildProcess>(arguments, folder_ / log);
  }

  bus::ParticipantOptions options(const std::string& service) const {
    return {0, tag_, "lo", {service, 0}};
  }

  /// The newest status of the recorder; health_fault and nothing else before the first.
  const scarab_ServiceStatus& status() {
    statuses_.take([this](const scarab_ServiceStatus& status) {
      if (std::string(status.service) != "logger") return;
      for (std::uint32_t i = 0; i < status.counters._length; ++i) {
        counters_[status.counters._buffer[i].name] = status.counters._buffer[i].value;
      }
      status_ = status;
      status_.service = nullptr;  // lent for the call only
      status_.counters = {};
    });
    return status_;
  }

  /// Of its newest status; 0 for one it has not reported.
  std::uint64_t counter(const std::string& name) {
    status();
    return counters_[name];
  }

  bool wait_for_reader(const bus::WriterEndpoint& writer) {
    return eventually([&] {
      for (const bus::Peer& peer : writer.matched()) {
        if (peer.service == "logger") return true;
      }
      return false;
    });
  }

  /// Tells the stack of a trial and waits until the recorder says that it is ready for it.
  bool wait_until_ready(std::uint32_t trial) {
    scarab_Trial announced{};
    announced.header.trial = trial;
    trials_.write(announced);
    return eventually([&] { return status().ready_trial == trial; });
  }

  /// As in lockstep: nobody runs further ahead of the recorder than a writer's history of 64
  /// samples reaches.
  bool may_write(std::uint32_t trial, std::uint32_t tick) {
    constexpr std::uint32_t kLead = 30;
    return tick < kLead ||
           (status().recorded_trial == trial && status().recorded_tick + kLead >= tick);
  }

  /// Writes a sample and remembers what it must look like in the log.
  template <class T>
  void write(bus::Writer<T>& writer, const T& sample) {
    writer.write(sample);
    const sample::Bytes bytes = bus::encode(sample);
    sent_[writer.topic()].push_back(mcap::copy_of({bytes.data(), bytes.size()}));
  }

  static scarab_RobotState robot_state(std::uint32_t trial, std::uint32_t tick) {
    scarab_RobotState state{};
    state.header = {trial, tick, tick * 100'000'000LL, 1'700'000'000'000'000'000LL + tick};
    for (std::uint32_t i = 0; i < 19; ++i) state.position_rad[i] = 0.01 * tick + 0.1 * i;
    return state;
  }

  mcap::test::TemporaryFolder folder_;
  std::string tag_ = "logger" + std::to_string(::getpid()) +
                     testing::UnitTest::GetInstance()->current_test_info()->name();
  bus::Participant participant_{options("plant")};
  bus::Reader<scarab_ServiceStatus> statuses_{participant_, bus::kServiceStatus};
  bus::Writer<scarab_Trial> trials_{participant_, bus::kTrial};
  Samples sent_;

 private:
  scarab_ServiceStatus status_{};
  std::map<std::string, std::uint64_t> counters_;
  int started_ = 0;
};

}  // namespace scarab::logger::test
