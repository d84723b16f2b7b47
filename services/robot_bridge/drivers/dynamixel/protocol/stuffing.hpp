#pragma once

#include <cstddef>
#include <optional>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"

/// Byte stuffing (ROBOTIS e-Manual, DYNAMIXEL Protocol 2.0, "Packet Process"): within INST..params
/// every FF FF FD is followed by an FD that means nothing, so that no header can be seen there.
namespace scarab::bridge::dynamixel {

/// `body` (instruction and parameters) as it goes over the wire.
[[nodiscard]] Bytes stuff(ByteView body);

/// `body` as it was before stuff(); none if an FF FF FD in it lacks its FD.
[[nodiscard]] std::optional<Bytes> unstuff(ByteView body);

/// Where in the first bytes of a body that is to be `whole` bytes long the byte stands that should
/// have been an FD and is not, or the end of the body where it is missing; none if all is well so
/// far.
[[nodiscard]] std::optional<std::size_t> find_unstuffed(ByteView begun, std::size_t whole);

}  // namespace scarab::bridge::dynamixel
