#pragma once

#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <stdexcept>
#include <vector>

#include "tests/interop/fastdds/matches.hpp"
#include "tests/interop/fastdds/topics.hpp"

namespace scarab::fastdds {

template <class Support>
class Reader final : private dds::DataReaderListener {
 public:
  using Sample = typename Support::type;

  Reader(Node& node, const Topic<Support>& topic, bool keep_all = false) : node_(node) {
    reader_ = node.subscriber().create_datareader(
        &node.topic(topic.name, dds::TypeSupport(new Support)),
        reader_qos(topic.profile, node.self(), keep_all), this,
        dds::StatusMask::data_available() << dds::StatusMask::subscription_matched());
    if (reader_ == nullptr) throw std::runtime_error(std::string("cannot read ") + topic.name);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
  ~Reader() override {
    reader_->set_listener(nullptr);
    node_.subscriber().delete_datareader(reader_);
  }

  /// Calls f for each sample that waits.
  template <class F>
  void take(F&& f) {
    dds::SampleInfo info;
    while (reader_->take_next_sample(&sample_, &info) == ReturnCode_t::RETCODE_OK) {
      if (info.valid_data) f(const_cast<const Sample&>(sample_));
    }
  }

  /// The writers it hears.
  [[nodiscard]] std::vector<Peer> matched() const { return node_.owners_of(matches_.all()); }

 private:
  void on_data_available(dds::DataReader* /*reader*/) override { node_.wake(); }
  void on_subscription_matched(dds::DataReader* /*reader*/,
                               const dds::SubscriptionMatchedStatus& info) override {
    matches_.note(eprosima::fastrtps::rtps::iHandle2GUID(info.last_publication_handle),
                  info.current_count_change);
    node_.wake();
  }

  Node& node_;
  Matches matches_;
  Sample sample_;
  dds::DataReader* reader_ = nullptr;
};

}  // namespace scarab::fastdds
