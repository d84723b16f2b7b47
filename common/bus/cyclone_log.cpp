#include "common/bus/cyclone_log.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <cstdio>
#include <string_view>

#include "common/bus/line_limit.hpp"

namespace scarab::bus {

namespace {

std::mutex& sink_turn() {
  static std::mutex turn;  // there is one log sink in a process
  return turn;
}

// Of what Cyclone says by itself: an interface that goes down would fill the disk.
constexpr std::uint32_t kLinesASecond = 10;

/// What nobody collects: to stderr.
void say(void* /*unused*/, const dds_log_data_t* data) {
  static std::mutex turn;
  static LineLimit limit(kLinesASecond);  // there is one log sink in a process
  const std::lock_guard lock(turn);
  const auto left_out = limit.admit(std::chrono::steady_clock::now());
  if (!left_out) return;
  if (*left_out > 0) {
    std::fprintf(stderr, "(%llu more lines of Cyclone DDS left out)\n",
                 static_cast<unsigned long long>(*left_out));
  }
  std::fputs(data->message, stderr);
}

}  // namespace

CycloneLog::CycloneLog() : turn_(sink_turn()) {
  const auto collect = [](void* self, const dds_log_data_t* data) {
    auto& log = *static_cast<CycloneLog*>(self);
    std::string_view message(data->message);
    while (!message.empty() && message.back() == '\n') message.remove_suffix(1);
    const std::lock_guard lock(log.mutex_);
    if (!log.text_.empty()) log.text_ += "; ";
    log.text_ += message;
  };
  dds_set_log_sink(collect, this);
}

CycloneLog::~CycloneLog() { dds_set_log_sink(say, nullptr); }

std::string CycloneLog::text() const {
  const std::lock_guard lock(mutex_);
  return text_;
}

}  // namespace scarab::bus
