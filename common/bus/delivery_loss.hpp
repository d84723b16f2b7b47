#pragma once

#include <cstdint>

#include "common/bus/endpoint.hpp"
#include "common/bus/error.hpp"

namespace scarab::bus {

/// What a reader did not get although it is matched, since its start.
struct DeliveryLoss {
  std::uint64_t lost = 0;      ///< gone from the writer before they came, or missed on the way
  std::uint64_t rejected = 0;  ///< came, and found no room
};

inline DeliveryLoss delivery_loss(const ReaderEndpoint& reader) {
  dds_sample_lost_status_t lost{};
  check(dds_get_sample_lost_status(reader.handle(), &lost), "lost samples of " + reader.topic());
  dds_sample_rejected_status_t rejected{};
  check(dds_get_sample_rejected_status(reader.handle(), &rejected),
        "rejected samples of " + reader.topic());
  return {lost.total_count, rejected.total_count};
}

}  // namespace scarab::bus
