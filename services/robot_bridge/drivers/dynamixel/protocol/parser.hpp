#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/packet.hpp"

namespace scarab::bridge::dynamixel {

/// What a parser has seen since it was made. A "header" is FF FF FD 00 wherever it stands.
struct ParserCounters {
  std::uint64_t packets = 0;          ///< accepted
  std::uint64_t bytes_dropped = 0;    ///< in no accepted packet
  std::uint64_t crc_errors = 0;       ///< headers whose packet had a wrong CRC
  std::uint64_t length_errors = 0;    ///< headers with an ID or a LEN that cannot be
  std::uint64_t stuffing_errors = 0;  ///< headers whose packet had an FF FF FD without its FD
  std::uint64_t cut_short = 0;        ///< headers whose packet was broken off by the next header
};

/// Finds the packets in a stream of bytes, of both directions. Accepts a packet only with the right
/// header, a possible ID, a possible LEN, its stuffing in order and the right CRC.
///
/// After any garbage, be it half a packet or a forged header, the first whole packet is found as
/// soon as its last byte is there, and the second one whatever the garbage was (a forged packet
/// that happens to fit the first one's bytes, CRC included, can take its place: 1 in 65536): a
/// stuffed packet cannot contain a header, so the next header ends it; inside a packet that is not
/// stuffed every header is followed up beside the packet itself.
///
/// Keeps at most kMaxFrameBytes between calls.
class Parser {
 public:
  /// Takes the next bytes of the stream and appends the packets that they complete.
  void feed(ByteView bytes, std::vector<Packet>& packets);

  /// Forgets what it keeps of an incomplete packet (counted as dropped).
  void reset();

  /// The beginning of a packet that is not complete yet, from its header on; may be empty.
  [[nodiscard]] ByteView pending() const { return buffer_; }

  [[nodiscard]] const ParserCounters& counters() const { return counters_; }

 private:
  enum class Verdict { kIncomplete, kAccepted, kLength, kStuffing, kCutShort, kCrc };

  void find_headers();
  void follow_up(std::vector<Packet>& packets);
  [[nodiscard]] Verdict judge(std::size_t header, Packet& packet, std::size_t& end) const;
  [[nodiscard]] Verdict judge_body(ByteView body, std::size_t whole) const;
  [[nodiscard]] std::size_t begun_header(std::size_t from) const;
  void count(Verdict verdict);
  void discard_before(std::size_t position);

  Bytes buffer_;
  std::vector<std::size_t> headers_;  ///< in buffer_, of packets that may still become complete
  std::size_t searched_ = 0;          ///< no header begins before this in buffer_ but those known
  ParserCounters counters_;
};

}  // namespace scarab::bridge::dynamixel
