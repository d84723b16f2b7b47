#include "common/bus/peer_hosts.hpp"

#include <gmock/gmock.h>

#include "common/bus/error.hpp"

namespace scarab::bus {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::StrEq;
using testing::ThrowsMessage;

const NetworkInterface kCable{"eth1", {"10.0.0.1", "fe80::1"}};

TEST(PeerHosts, ThisHostIsAskedToo) {
  EXPECT_THAT(hosts_to_ask({"10.0.0.2", "10.0.0.3"}, kCable),
              ElementsAre("10.0.0.2", "10.0.0.3", "10.0.0.1"));
}

TEST(PeerHosts, WithoutPeersNobodyIsAsked) { EXPECT_THAT(hosts_to_ask({}, kCable), IsEmpty()); }

TEST(PeerHosts, AnUnknownNameIsAnError) {
  EXPECT_THAT([] { hosts_to_ask({"no-such-host.invalid"}, kCable); },
              ThrowsMessage<Error>(StrEq("peer no-such-host.invalid: no such host")));
}

TEST(PeerHosts, LoopbackLeadsToNoOtherHost) {
  const auto loopback = find_interface("lo");
  ASSERT_TRUE(loopback);
  EXPECT_THAT([&] { hosts_to_ask({"10.0.0.2"}, *loopback); },
              ThrowsMessage<Error>(StrEq(
                  "peer 10.0.0.2 cannot be reached over lo: name the interface that leads there")));
  EXPECT_THAT(hosts_to_ask({"localhost"}, *loopback), Contains("127.0.0.1"));
}

TEST(NetworkInterfaceTest, FoundByNameAndByAddress) {
  ASSERT_TRUE(find_interface("lo"));
  EXPECT_EQ(find_interface("127.0.0.1")->name, "lo");
  EXPECT_EQ(find_interface("lo")->addresses.front(), "127.0.0.1");
  EXPECT_FALSE(find_interface("eth7"));
}

}  // namespace
}  // namespace scarab::bus
