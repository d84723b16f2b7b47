#include "services/robot_bridge/drivers/dynamixel/question.hpp"

#include <algorithm>
#include <utility>

#include "services/robot_bridge/drivers/dynamixel/protocol/fast_status.hpp"

namespace scarab::bridge::dynamixel {

Question::Question(Packet instruction, std::size_t data_bytes)
    : ids_{instruction.id},
      answers_(1),
      data_bytes_(data_bytes),
      single_(std::move(instruction)),
      last_id_(ids_.back()) {}

Question::Question(Region region, std::vector<std::uint8_t> ids, SyncReadKind kind)
    : ids_(std::move(ids)),
      answers_(ids_.size()),
      data_bytes_(region.size),
      region_(region),
      kind_(kind),
      last_id_(ids_.back()) {}

void Question::begin_attempt() {
  if (is_together()) answers_.assign(ids_.size(), std::nullopt);  // they come all or not at all
  refusal_.reset();
  last_id_ = missing().back();
  over_ = false;
}

Packet Question::instruction() const {
  if (single_) return *single_;
  return is_together() ? fast_sync_read(region_, ids_) : sync_read(region_, missing());
}

std::size_t Question::answer_bytes() const {
  return is_together() ? fast_status_bytes(ids_.size(), data_bytes_)
                       : missing().size() * status_bytes(data_bytes_);
}

bool Question::take(const Status& status) {
  const auto found = std::find(ids_.begin(), ids_.end(), status.id);
  if (found == ids_.end()) return false;
  std::optional<Status>& answer = answers_[static_cast<std::size_t>(found - ids_.begin())];
  if (answer) return false;
  if (status.error != StatusError::kNone) {
    refusal_ = status;
  } else if (status.data.size() == data_bytes_) {
    answer = status;
  } else {
    return false;
  }
  over_ = over_ || status.id == last_id_;
  return true;
}

bool Question::take(const Packet& packet) {
  if (!is_together()) {
    const auto status = as_status(packet);
    return status && take(*status);
  }
  const auto statuses = as_fast_status(packet, data_bytes_);
  if (!statuses || statuses->size() != ids_.size()) return false;
  return std::all_of(statuses->begin(), statuses->end(),
                     [this](const Status& status) { return take(status); });
}

std::vector<std::uint8_t> Question::missing() const {
  std::vector<std::uint8_t> ids;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (!answers_[i]) ids.push_back(ids_[i]);
  }
  return ids;
}

std::vector<Status> Question::answers() const {
  std::vector<Status> statuses;
  for (const auto& answer : answers_) statuses.push_back(answer.value());
  return statuses;
}

Question::Silence Question::silence(ByteView begun, bool faults) const {
  if (!is_together()) {
    const std::vector<std::uint8_t> ids = missing();
    return {ids.front(), !faults && ids.size() > 1 && ids.size() == ids_.size(), faults};
  }
  const std::size_t answered = answered_so_far(begun, data_bytes_).size();
  const bool more = answered > 0 && begun.size() > fast_status_bytes(answered, data_bytes_);
  return {ids_[std::min(answered, ids_.size() - 1)], begun.empty() && !faults && ids_.size() > 1,
          faults || more};
}

}  // namespace scarab::bridge::dynamixel
