#include "common/bus/domain_config.hpp"

#include <gmock/gmock.h>

namespace scarab::bus {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(DomainConfig, BuiltInIsLoopbackWithRoomForManyParticipants) {
  const std::string config = domain_config({}, std::nullopt);
  EXPECT_THAT(config, HasSubstr("NetworkInterface name=\"lo\""));
  EXPECT_THAT(config, HasSubstr("<MaxAutoParticipantIndex>63<"));
  EXPECT_THAT(config, HasSubstr("<LeaseDuration>12s<"));
  EXPECT_THAT(config, HasSubstr("<SPDPInterval>1s<"));
  EXPECT_THAT(config, Not(HasSubstr("<Tag>")));
}

TEST(DomainConfig, OptionsAppear) {
  const std::string config = domain_config({7, "a<b&$", "10.0.0.1", {}}, std::nullopt);
  EXPECT_THAT(config, HasSubstr("<ExternalDomainId>7<"));
  EXPECT_THAT(config, HasSubstr("<Tag>a&lt;b&amp;&#36;</Tag>"));
  EXPECT_THAT(config, HasSubstr("NetworkInterface address=\"10.0.0.1\""));
}

TEST(DomainConfig, WithPeersNothingIsSentByMulticast) {
  ParticipantOptions options;
  options.interface = "eth1";
  options.peers = {"10.0.0.2", "rover"};
  const std::string config = domain_config(options, std::nullopt);
  EXPECT_THAT(config, HasSubstr("multicast=\"false\""));
  EXPECT_THAT(config, HasSubstr("<AllowMulticast>false<"));
  EXPECT_THAT(config, HasSubstr("<Peer address=\"10.0.0.2\"/><Peer address=\"rover\"/>"));
  // Else nobody who is asked would answer.
  EXPECT_THAT(config, HasSubstr("<ParticipantIndex>auto<"));
}

TEST(DomainConfig, PeersAreLaidOverABase) {
  ParticipantOptions options;
  options.peers = {"10.0.0.2"};
  const std::string config = domain_config(options, "file:///etc/c.xml");
  EXPECT_THAT(config, StartsWith("file:///etc/c.xml,<"));
  EXPECT_THAT(config, HasSubstr("<Peer address=\"10.0.0.2\"/>"));
  EXPECT_THAT(config, HasSubstr("<AllowMulticast>false<"));
  EXPECT_THAT(config, HasSubstr("<ParticipantIndex>auto<"));
}

TEST(DomainConfig, SamplesAreGatheredOnlyWhereAskedFor) {
  EXPECT_THAT(domain_config({}, std::nullopt), Not(HasSubstr("WriteBatch")));
  ParticipantOptions options;
  options.gathers_samples = true;
  EXPECT_THAT(domain_config(options, std::nullopt), HasSubstr("<WriteBatch>true<"));
  EXPECT_THAT(domain_config(options, "file:///etc/c.xml"), HasSubstr("<WriteBatch>true<"));
}

TEST(DomainConfig, ABaseIsOnlyOverriddenByWhatWasGiven) {
  const std::string config = domain_config({0, "", "lo", {}}, "file:///etc/c.xml");
  EXPECT_THAT(config, StartsWith("file:///etc/c.xml,<"));
  EXPECT_THAT(config, Not(HasSubstr("NetworkInterface")));
  EXPECT_THAT(config, Not(HasSubstr("Lease")));
  EXPECT_THAT(domain_config({0, "t", "eth1", {}}, "file:///etc/c.xml"),
              HasSubstr("NetworkInterface name=\"eth1\""));
}

}  // namespace
}  // namespace scarab::bus
