#include "tools/topic/publication.hpp"

#include "common/bus/clock.hpp"
#include "common/bus/topics.hpp"
#include "common/runtime/peers.hpp"
#include "common/runtime/program.hpp"
#include "tools/topic/failure.hpp"
#include "tools/topic/named_type.hpp"
#include "tools/topic/offered_qos.hpp"
#include "tools/topic/quantity.hpp"

namespace scarab::topic {
namespace {

/// Of one of the project's own topics; null for any other.
bus::TopicType declared_type(const std::string& topic) {
  bus::TopicType found;
  bus::for_each_topic([&](const auto& known) {
    using Sample = typename std::decay_t<decltype(known)>::Type;
    if (topic == known.name) found = bus::borrow_compiled(bus::descriptor<Sample>());
  });
  return found;
}

std::string seconds(std::chrono::milliseconds duration) {
  return seconds_text(std::chrono::duration<double>(duration).count());
}

}  // namespace

Publication::Publication(Session& session, const PublicationOptions& options)
    : session_(session),
      options_(options),
      end_(after(options.timeout)),
      type_(find_type()),
      model_(understood(type_)) {}

bus::TopicType Publication::find_type() {
  if (!options_.type.empty()) return find_named_type(session_, options_.type, end_);
  if (bus::TopicType declared = declared_type(options_.topic)) return declared;
  return session_.type_of(session_.wait_for_endpoints(options_.topic, end_));
}

sample::Bytes Publication::encode(const std::string& source,
                                  const sample::WrittenValue& value) const {
  sample::Bytes out;
  refuse_bad_usage(source, [&] { out = sample::build_cdr(model_, value, bus::now_ns()); });
  return out;
}

void Publication::open() {
  // With the QoS of the readers there are, so they have to be known first.
  if (options_.readers > 0) session_.wait_for_readers(options_.topic, options_.readers, end_);
  const auto endpoints = session_.view().of_topic(options_.topic);
  writer_.emplace(session_.participant(), options_.topic, type_,
                  offered_qos(options_.topic, endpoints));
  while (writer_->matched().size() < options_.readers) {
    if (session_.interrupted()) throw Interrupted{};
    if (Clock::now() < end_) {
      // A match wakes nobody: looks again soon.
      session_.wait(std::min(end_, after(std::chrono::milliseconds(5))));
      continue;
    }
    std::string reason = std::to_string(writer_->matched().size()) + " of " +
                         std::to_string(options_.readers) + " readers of " + options_.topic +
                         " have matched within " + seconds(options_.timeout);
    for (const std::string& fault : writer_->faults()) reason += "; " + fault;
    throw Failure(kExitTimeout, reason);
  }
}

void Publication::write(const sample::Bytes& sample) { writer_->write(sample); }

void Publication::finish() {
  if (writer_->await_acknowledged(options_.timeout)) return;
  throw Failure(kExitTimeout, "not every reader of " + options_.topic +
                                  " has acknowledged within " + seconds(options_.timeout));
}

}  // namespace scarab::topic
