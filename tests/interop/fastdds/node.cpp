#include "tests/interop/fastdds/node.hpp"

#include <fastdds/rtps/reader/ReaderDiscoveryInfo.h>
#include <fastdds/rtps/writer/WriterDiscoveryInfo.h>

#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <stdexcept>

#include "tests/interop/fastdds/qos.hpp"

namespace scarab::fastdds {
namespace {

dds::DomainParticipantFactory& factory() { return *dds::DomainParticipantFactory::get_instance(); }

}  // namespace

Node::Node(std::uint32_t domain, const std::string& address, const Peer& self) : self_(self) {
  participant_ = factory().create_participant(domain, participant_qos(address, self), this,
                                              dds::StatusMask::none());
  if (participant_ == nullptr) {
    throw std::runtime_error("cannot join domain " + std::to_string(domain) + " on " + address);
  }
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  subscriber_ = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (publisher_ == nullptr || subscriber_ == nullptr) {
    throw std::runtime_error("cannot create publisher and subscriber");
  }
}

Node::~Node() {
  participant_->set_listener(nullptr);
  participant_->delete_contained_entities();
  factory().delete_participant(participant_);
}

dds::Topic& Node::topic(const std::string& name, dds::TypeSupport type) {
  if (auto* known = participant_->lookup_topicdescription(name)) {
    return dynamic_cast<dds::Topic&>(*known);
  }
  type.register_type(participant_);
  auto* topic = participant_->create_topic(name, type.get_type_name(), dds::TOPIC_QOS_DEFAULT);
  if (topic == nullptr) throw std::runtime_error("cannot create topic " + name);
  return *topic;
}

void Node::wait(std::chrono::milliseconds limit) {
  std::unique_lock lock(mutex_);
  happened_.wait_for(lock, limit, [this] { return news_; });
  news_ = false;
}

void Node::wake() {
  {
    const std::lock_guard lock(mutex_);
    news_ = true;
  }
  happened_.notify_one();
}

std::vector<Peer> Node::owners_of(const std::set<Guid>& endpoints) const {
  const std::lock_guard lock(mutex_);
  std::vector<Peer> peers;
  for (const Guid& endpoint : endpoints) {
    const auto owner = owners_.find(endpoint);
    if (owner != owners_.end()) peers.push_back(owner->second);
  }
  return peers;
}

template <class Endpoint>
void Node::remember(const Endpoint& endpoint) {
  const auto& bytes = endpoint.m_qos.m_userData.getValue();
  {
    const std::lock_guard lock(mutex_);
    owners_[endpoint.guid()] = peer_of({bytes.begin(), bytes.end()});
  }
  wake();
}

void Node::on_subscriber_discovery(dds::DomainParticipant* /*participant*/,
                                   eprosima::fastrtps::rtps::ReaderDiscoveryInfo&& info) {
  remember(info.info);
}

void Node::on_publisher_discovery(dds::DomainParticipant* /*participant*/,
                                  eprosima::fastrtps::rtps::WriterDiscoveryInfo&& info) {
  remember(info.info);
}

}  // namespace scarab::fastdds
