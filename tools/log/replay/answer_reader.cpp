#include "tools/log/replay/answer_reader.hpp"

#include <stdexcept>

#include "common/bus/topic_type.hpp"
#include "tools/log/channel_type.hpp"

namespace scarab::log {
namespace {

template <class T>
class TypedReader : public AnswerReader {
 public:
  TypedReader(bus::Participant& participant, const bus::Topic<T>& topic)
      : reader_(participant, topic, keep_all()) {
    channel_.topic = topic.name;
    channel_.type = bus::model_of(bus::descriptor<T>());
    channel_.type_name = channel_.type->name();
    channel_.has_header = begins_with_header(*channel_.type);
  }

  const std::string& topic() const override { return reader_.topic(); }
  bus::ReaderEndpoint& endpoint() override { return reader_; }
  const LogChannel& channel() const override { return channel_; }
  void take(const Visitor& visit) override {
    reader_.take([&](const T& sample) {
      const sample::Bytes cdr = bus::encode(sample);
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(cdr.data());
      const scarab_Header& header = sample.header;
      visit({header.trial, header.tick, header.sim_time_ns, header.stamp_ns},
            {bytes, bytes + cdr.size()});
    });
  }

 private:
  static bus::ReaderOptions keep_all() {
    bus::ReaderOptions options;
    options.keep_all = true;
    return options;
  }

  bus::Reader<T> reader_;
  LogChannel channel_;
};

}  // namespace

std::unique_ptr<AnswerReader> read_answers(bus::Participant& participant,
                                           const std::string& topic) {
  std::unique_ptr<AnswerReader> made;
  bus::for_each_topic([&](const auto& known) {
    using T = typename std::decay_t<decltype(known)>::Type;
    if (topic == known.name) made = std::make_unique<TypedReader<T>>(participant, known);
  });
  if (!made) throw std::invalid_argument(topic + " is no topic of the chain");
  return made;
}

}  // namespace scarab::log
