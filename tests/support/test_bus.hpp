#pragma once

#include <cstdint>
#include <string>

#include "common/bus/cdr.hpp"
#include "common/bus/participant.hpp"
#include "common/bus/raw_cdr.hpp"

namespace scarab::test {

/// The discovery tag of the running test: it keeps its participants and programs apart from all
/// others.
std::string test_tag();

/// Options of a participant of the running test on loopback.
bus::ParticipantOptions test_options(const std::string& service, std::uint32_t instance = 0);

/// The bytes of a sample of the chain without its wall-clock stamp: what equal runs have in common.
template <class T>
sample::Bytes timeless_bytes(T sample) {
  sample.header.stamp_ns = 0;
  return bus::encode(sample);
}

}  // namespace scarab::test
