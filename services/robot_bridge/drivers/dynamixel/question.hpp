#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "services/robot_bridge/drivers/dynamixel/config.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/instructions.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

namespace scarab::bridge::dynamixel {

/// An instruction that is answered, and the answers to it so far.
class Question {
 public:
  /// To one device, which answers with `data_bytes` of data.
  Question(Packet instruction, std::size_t data_bytes);
  /// For the same region of several devices.
  Question(Region region, std::vector<std::uint8_t> ids, SyncReadKind kind);

  /// Before each instruction(): what only counts for one attempt is forgotten.
  void begin_attempt();
  /// What to send: devices that have answered for themselves are not asked again.
  [[nodiscard]] Packet instruction() const;
  /// Bytes on the line of the answers that instruction() brings, but for stuffing.
  [[nodiscard]] std::size_t answer_bytes() const;

  /// The answer or answers in a packet. False: it is not of the kind that was asked for, from a
  /// device that was not asked or has answered, or not as long as it should be.
  bool take(const Packet& packet);

  [[nodiscard]] bool complete() const { return missing().empty(); }
  /// Those who have not answered, in the order asked.
  [[nodiscard]] std::vector<std::uint8_t> missing() const;
  /// No more answers will come in this attempt: the last device asked has spoken.
  [[nodiscard]] bool over() const { return over_; }
  /// In the order asked, of a complete one.
  [[nodiscard]] std::vector<Status> answers() const;
  /// The last answer that was an error number in place of what was asked.
  [[nodiscard]] const std::optional<Status>& refusal() const { return refusal_; }

  /// What is known of those who have not answered.
  struct Silence {
    std::uint8_t first = 0;  ///< the first one in the order
    bool of_all = false;     ///< of several, and nobody has said a word
    bool broken = false;     ///< they have spoken, but not in a way that could be understood
  };
  /// `begun`: what has come of an answer that never became complete. `faults`: something has come
  /// that was refused.
  [[nodiscard]] Silence silence(ByteView begun, bool faults) const;

 private:
  bool take(const Status& status);
  [[nodiscard]] bool is_together() const { return kind_ == SyncReadKind::kFast; }

  std::vector<std::uint8_t> ids_;
  std::vector<std::optional<Status>> answers_;  ///< as ids_
  std::size_t data_bytes_;
  std::optional<Packet> single_;  ///< to one device
  Region region_;
  SyncReadKind kind_ = SyncReadKind::kPlain;
  std::optional<Status> refusal_;
  std::uint8_t last_id_;  ///< of those asked in this attempt
  bool over_ = false;
};

}  // namespace scarab::bridge::dynamixel
