#include "tools/emulator/wire/byte_noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bitset>
#include <vector>

namespace scarab::emulator {
namespace {

constexpr int kBytes = 20000;

std::vector<int> pass_all(ByteNoise noise, double lose, double flip) {
  std::vector<int> out;
  for (int i = 0; i < kBytes; ++i) {
    const auto byte = noise.pass(0x5A, lose, flip);
    out.push_back(byte ? *byte : -1);
  }
  return out;
}

TEST(ByteNoise, WithoutFaultsNothingChanges) {
  EXPECT_EQ(pass_all(ByteNoise(1, "in"), 0, 0), std::vector<int>(kBytes, 0x5A));
}

TEST(ByteNoise, LosesAsManyAsItIsTold) {
  const auto bytes = pass_all(ByteNoise(1, "in"), 0.1, 0);
  const auto lost = std::count(bytes.begin(), bytes.end(), -1);
  EXPECT_NEAR(static_cast<double>(lost), 0.1 * kBytes, 0.01 * kBytes);
  EXPECT_EQ(std::count(bytes.begin(), bytes.end(), 0x5A) + lost, kBytes);
  EXPECT_EQ(pass_all(ByteNoise(1, "in"), 1, 0), std::vector<int>(kBytes, -1));
}

TEST(ByteNoise, FlipsOneBitOfAsManyAsItIsTold) {
  std::bitset<8> which;
  int flipped = 0;
  for (const int byte : pass_all(ByteNoise(1, "in"), 0, 0.1)) {
    const std::bitset<8> difference(static_cast<unsigned>(byte) ^ 0x5AU);
    EXPECT_LE(difference.count(), 1U);
    which |= difference;
    flipped += static_cast<int>(difference.count());
  }
  EXPECT_NEAR(flipped, 0.1 * kBytes, 0.01 * kBytes);
  EXPECT_TRUE(which.all()) << "each of the eight";
}

TEST(ByteNoise, IsOfItsSeedAndDirectionOnly) {
  const auto first = pass_all(ByteNoise(7, "in"), 0.2, 0.2);
  EXPECT_EQ(first, pass_all(ByteNoise(7, "in"), 0.2, 0.2));
  EXPECT_NE(first, pass_all(ByteNoise(8, "in"), 0.2, 0.2));
  EXPECT_NE(first, pass_all(ByteNoise(7, "out"), 0.2, 0.2));
}

}  // namespace
}  // namespace scarab::emulator
