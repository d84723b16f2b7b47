#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "tests/interop/fastdds/peer.hpp"

namespace scarab::fastdds {

namespace dds = eprosima::fastdds::dds;
using Guid = eprosima::fastrtps::rtps::GUID_t;

/// A Fast DDS participant that looks like a service of the stack. The vendor's threads only take
/// note of what happens, and wake the one thread that waits here.
class Node final : private dds::DomainParticipantListener {
 public:
  /// Throws std::runtime_error if the domain cannot be joined.
  Node(std::uint32_t domain, const std::string& address, const Peer& self);
  Node(const Node&) = delete;
  Node& operator=(const Node&) = delete;
  ~Node() override;

  [[nodiscard]] const Peer& self() const { return self_; }
  [[nodiscard]] dds::Publisher& publisher() { return *publisher_; }
  [[nodiscard]] dds::Subscriber& subscriber() { return *subscriber_; }
  /// The topic, created when it is asked for first.
  dds::Topic& topic(const std::string& name, dds::TypeSupport type);

  /// Until something has happened since the last call, at most for `limit`.
  void wait(std::chrono::milliseconds limit);
  /// Something has happened.
  void wake();

  /// Who says in its user data that these endpoints are its own.
  [[nodiscard]] std::vector<Peer> owners_of(const std::set<Guid>& endpoints) const;

 private:
  void on_subscriber_discovery(dds::DomainParticipant* participant,
                               eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) override;
  void on_publisher_discovery(dds::DomainParticipant* participant,
                              eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) override;
  template <class Endpoint>
  void remember(const Endpoint& endpoint);

  Peer self_;
  mutable std::mutex mutex_;
  std::condition_variable happened_;
  bool news_ = false;
  std::map<Guid, Peer> owners_;
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  dds::Subscriber* subscriber_ = nullptr;
};

}  // namespace scarab::fastdds
