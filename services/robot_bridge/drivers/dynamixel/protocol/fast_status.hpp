#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

/// The one status that all devices send together when they answer a fast sync read (e-Manual,
/// Protocol 2.0, "Fast Sync Read"): it comes from the broadcast ID, is not stuffed, and its
/// parameters are, one device after the other,
///
///     ERR | ID | data | CRC_L CRC_H
///
/// Each CRC goes on from the header over all that came before it, the devices' CRCs included; so
/// the last one is that of the whole packet. The first device sends the header and LEN, too.
namespace scarab::bridge::dynamixel {

/// How long that packet is on the wire, `data_bytes` from each device.
[[nodiscard]] std::size_t fast_status_bytes(std::size_t devices, std::size_t data_bytes);

/// The bytes on the wire, a chunk for each device in the order asked, as they send them in turn.
/// All data must be of one length; throws std::invalid_argument if not, or if they are too many.
[[nodiscard]] std::vector<Bytes> encode_fast_status(const std::vector<Status>& statuses);

/// The devices' parts of such a packet, `data_bytes` from each; none if it is something else.
[[nodiscard]] std::optional<std::vector<Status>> as_fast_status(const Packet& packet,
                                                                std::size_t data_bytes);

/// The devices that have answered, whole and with the right CRC, in the beginning of a frame that
/// never became complete: the next one asked is the one that is silent. Empty if `begun` is no
/// beginning of such a frame.
[[nodiscard]] std::vector<Status> answered_so_far(ByteView begun, std::size_t data_bytes);

}  // namespace scarab::bridge::dynamixel
