#include "services/robot_bridge/drivers/dynamixel/protocol/parser.hpp"

#include <algorithm>
#include <array>

#include "services/robot_bridge/drivers/dynamixel/protocol/crc16.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/stuffing.hpp"

namespace scarab::bridge::dynamixel {
namespace {

constexpr std::array<std::uint8_t, 4> kHeader = {0xFF, 0xFF, 0xFD, 0x00};
constexpr std::size_t kIdAt = 4;
constexpr std::size_t kLengthAt = 5;
constexpr std::size_t kShortest = 1 + kCrcBytes;  // LEN of an instruction without parameters

bool possible(std::uint8_t id, std::size_t length) {
  return (id <= kMaxId || id == kBroadcastId) && length >= kShortest && length <= kMaxLength;
}

}  // namespace

void Parser::feed(ByteView bytes, std::vector<Packet>& packets) {
  while (!bytes.empty()) {
    const std::size_t part = std::min(bytes.size(), kMaxFrameBytes);
    buffer_.insert(buffer_.end(), bytes.begin(), bytes.begin() + part);
    bytes = bytes.from(part);
    find_headers();
    follow_up(packets);
  }
}

void Parser::reset() {
  headers_.clear();
  counters_.bytes_dropped += buffer_.size();
  discard_before(buffer_.size());
}

void Parser::find_headers() {
  while (true) {
    const auto from = buffer_.begin() + static_cast<std::ptrdiff_t>(searched_);
    const auto found = std::search(from, buffer_.end(), kHeader.begin(), kHeader.end());
    if (found == buffer_.end()) break;
    searched_ = static_cast<std::size_t>(found - buffer_.begin());
    headers_.push_back(searched_++);
  }
  // The last three bytes may be the beginning of one.
  if (buffer_.size() >= kHeader.size()) {
    searched_ = std::max(searched_, buffer_.size() - kHeader.size() + 1);
  }
}

void Parser::follow_up(std::vector<Packet>& packets) {
  std::size_t taken = 0;  // end of the last accepted packet
  std::vector<std::size_t> open;
  for (const std::size_t header : headers_) {
    if (header < taken) continue;  // data of an accepted packet that looked like a header
    Packet packet;
    std::size_t end = 0;
    const Verdict verdict = judge(header, packet, end);
    count(verdict);
    if (verdict == Verdict::kIncomplete) open.push_back(header);
    if (verdict != Verdict::kAccepted) continue;
    counters_.bytes_dropped += header - taken;
    taken = end;
    open.clear();  // what began before an accepted packet and went on behind it never was one
    packets.push_back(std::move(packet));
  }
  headers_ = std::move(open);

  const std::size_t kept = headers_.empty() ? begun_header(taken) : headers_.front();
  counters_.bytes_dropped += kept - taken;
  discard_before(kept);
}

std::size_t Parser::begun_header(std::size_t from) const {
  from = std::max(from, searched_);
  const auto begins_header = [&] {
    const auto at = buffer_.begin() + static_cast<std::ptrdiff_t>(from);
    return std::equal(at, buffer_.end(), kHeader.begin());
  };
  while (!begins_header()) ++from;  // ends at the latest with nothing left
  return from;
}

Parser::Verdict Parser::judge(std::size_t header, Packet& packet, std::size_t& end) const {
  const ByteView frame = ByteView(buffer_).from(header);
  if (frame.size() < kPrefixBytes) return Verdict::kIncomplete;
  const std::size_t length = read_little(frame.slice(kLengthAt, 2));
  if (!possible(frame[kIdAt], length)) return Verdict::kLength;
  if (frame.size() == kPrefixBytes) return Verdict::kIncomplete;

  const std::size_t whole = length - kCrcBytes;  // of the body
  const ByteView body = frame.slice(kPrefixBytes, std::min(frame.size() - kPrefixBytes, whole));
  const bool stuffed = !is_never_stuffed(frame[kIdAt], body[0]);
  if (stuffed) {
    const Verdict verdict = judge_body(body, whole);
    if (verdict != Verdict::kAccepted) return verdict;
  }
  if (frame.size() < kPrefixBytes + length) return Verdict::kIncomplete;

  const ByteView checked = frame.slice(0, kPrefixBytes + whole);
  if (crc16(checked) != read_little(frame.slice(checked.size(), kCrcBytes))) return Verdict::kCrc;
  packet.id = frame[kIdAt];
  packet.instruction = body[0];
  packet.parameters = (stuffed ? *unstuff(body) : body.copy());
  packet.parameters.erase(packet.parameters.begin());
  end = header + kPrefixBytes + length;
  return Verdict::kAccepted;
}

Parser::Verdict Parser::judge_body(ByteView body, std::size_t whole) const {
  const auto fault = find_unstuffed(body, whole);
  if (!fault) return Verdict::kAccepted;
  const bool next_header = *fault < body.size() && body[*fault] == kHeader.back();
  return next_header ? Verdict::kCutShort : Verdict::kStuffing;
}

void Parser::count(Verdict verdict) {
  switch (verdict) {
    case Verdict::kIncomplete:
      return;
    case Verdict::kAccepted:
      ++counters_.packets;
      return;
    case Verdict::kLength:
      ++counters_.length_errors;
      return;
    case Verdict::kStuffing:
      ++counters_.stuffing_errors;
      return;
    case Verdict::kCutShort:
      ++counters_.cut_short;
      return;
    case Verdict::kCrc:
      ++counters_.crc_errors;
      return;
  }
}

void Parser::discard_before(std::size_t position) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(position));
  searched_ -= std::min(searched_, position);
  for (std::size_t& header : headers_) header -= position;
}

}  // namespace scarab::bridge::dynamixel
