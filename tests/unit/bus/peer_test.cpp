#include "common/bus/peer.hpp"

#include <gtest/gtest.h>

namespace scarab::bus {
namespace {

TEST(Peer, SurvivesTheRoundTrip) {
  for (const Peer& peer : {Peer{"premotor", 0}, Peer{"robot_bridge", 4294967295U}}) {
    EXPECT_EQ(decode_peer(encode_peer(peer)), peer);
  }
}

TEST(Peer, AnythingElseIsForeign) {
  for (const char* text :
       {"", "scarab", "scarab:", "scarab::1", "scarab:premotor",
        "scarab:premotor:", "scarab:premotor:x", "scarab:premotor:1 ", "scarab:premotor:-1",
        "scarab:premotor:4294967296", "other:premotor:1"}) {
    EXPECT_EQ(decode_peer(text), Peer{}) << text;
  }
  EXPECT_EQ(to_string(Peer{}), "foreign");
  EXPECT_EQ(to_string(Peer{"premotor", 1}), "premotor/1");
}

}  // namespace
}  // namespace scarab::bus
