#include "common/bus/cyclone_log.hpp"

#include <dds/dds.h>
#include <dds/ddsrt/log.h>

#include <string_view>

namespace scarab::bus {

namespace {

std::mutex& sink_turn() {
  static std::mutex turn;  // there is one log sink in a process
  return turn;
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

CycloneLog::~CycloneLog() { dds_set_log_sink(nullptr, nullptr); }

std::string CycloneLog::text() const {
  const std::lock_guard lock(mutex_);
  return text_;
}

}  // namespace scarab::bus
