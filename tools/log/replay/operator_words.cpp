#include "tools/log/replay/operator_words.hpp"

#include <string>

#include "common/bus/cdr.hpp"
#include "common/bus/error.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/status_publisher.hpp"

namespace scarab::log {
namespace {

using Tick = std::pair<std::uint32_t, std::uint32_t>;  // trial, tick

/// The others are for the tick master.
bool is_for_the_supervisor(scarab_OperatorCommand command) {
  return command >= scarab_OPERATOR_AUTOMATIC;
}

/// What the log says about words, by the stamp of each.
struct Record {
  std::map<std::int64_t, OperatorWords::Word> said;
  std::map<std::int64_t, Tick> heard;
};

void note_status(const scarab_ServiceStatus& status, const bus::Peer& service, Record& record) {
  if (bus::Peer{status.service, status.instance} != service) return;
  for (const scarab_Counter& counter : bus::elements(status.counters)) {
    if (bus::text(counter.name) != runtime::kOperatorStamp) continue;
    record.heard.try_emplace(static_cast<std::int64_t>(counter.value),
                             Tick{status.header.trial, status.header.tick});
  }
}

void note(const LogChannel& channel, const mcap::Message& message, const bus::Peer& service,
          Record& record) try {
  if (channel.topic == bus::kOperator.name) {
    const auto word = bus::decode<scarab_Operator>(cdr_of(message));
    if (!is_for_the_supervisor(word->command)) return;
    record.said.try_emplace(word->header.stamp_ns,
                            OperatorWords::Word{&channel, mcap::copy_of(message.data)});
  } else {
    note_status(*bus::decode<scarab_ServiceStatus>(cdr_of(message)), service, record);
  }
} catch (const bus::Error&) {
  // A log from before these types were as they are: then its words go by their time.
}

}  // namespace

OperatorWords::OperatorWords(const Log& log, const bus::Peer& service) {
  if (service.service != "supervisor" || log.find(bus::kOperator.name) == nullptr) return;
  Record record;
  log.for_each(
      [&](const LogChannel& channel, const mcap::Message& message) {
        note(channel, message, service, record);
        return true;
      },
      {bus::kOperator.name, bus::kServiceStatus.name});
  for (auto& [stamp_ns, word] : record.said) {
    // Of several words heard in one tick only the last is acknowledged.
    const auto heard = record.heard.lower_bound(stamp_ns);
    if (heard == record.heard.end()) continue;
    words_[heard->second].push_back(std::move(word));
    known_.insert(stamp_ns);
  }
}

const std::vector<OperatorWords::Word>& OperatorWords::counting_from(std::uint32_t trial,
                                                                     std::uint32_t tick) const {
  static const std::vector<Word> kNone;
  const auto found = words_.find({trial, tick});
  return found == words_.end() ? kNone : found->second;
}

}  // namespace scarab::log
