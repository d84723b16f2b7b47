#pragma once

#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/interop/fastdds/matches.hpp"
#include "tests/interop/fastdds/topics.hpp"

namespace scarab::fastdds {

template <class Support>
class Writer final : private dds::DataWriterListener {
 public:
  using Sample = typename Support::type;

  Writer(Node& node, const Topic<Support>& topic) : node_(node), name_(topic.name) {
    writer_ = node.publisher().create_datawriter(
        &node.topic(topic.name, dds::TypeSupport(new Support)),
        writer_qos(topic.profile, node.self()), this, dds::StatusMask::publication_matched());
    if (writer_ == nullptr) throw std::runtime_error("cannot write " + name_);
  }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() override {
    writer_->set_listener(nullptr);
    node_.publisher().delete_datawriter(writer_);
  }

  /// Throws std::runtime_error where the vendor refuses it.
  void write(Sample& sample) {
    if (!writer_->write(&sample)) throw std::runtime_error(name_ + ": the sample was not written");
  }

  /// The readers it reaches.
  [[nodiscard]] std::vector<Peer> matched() const { return node_.owners_of(matches_.all()); }

 private:
  void on_publication_matched(dds::DataWriter* /*writer*/,
                              const dds::PublicationMatchedStatus& info) override {
    matches_.note(eprosima::fastrtps::rtps::iHandle2GUID(info.last_subscription_handle),
                  info.current_count_change);
    node_.wake();
  }

  Node& node_;
  std::string name_;
  Matches matches_;
  dds::DataWriter* writer_ = nullptr;
};

}  // namespace scarab::fastdds
