#include "services/logger/batch_queue.hpp"

namespace scarab::logger {

bool BatchQueue::push(SampleBatch&& batch) {
  const std::lock_guard lock(mutex_);
  if (closed_) {
    return false;
  }
  if (batch.entries().empty() && !batches_.empty() && batches_.back().entries().empty()) {
    batches_.back().absorb(std::move(batch));
    return true;
  }
  size_bytes_ += batch.size_bytes();
  batches_.push_back(std::move(batch));
  has_batch_.notify_one();
  return true;
}

bool BatchQueue::full() const {
  const std::lock_guard lock(mutex_);
  return is_full();
}

bool BatchQueue::wait_for_room(std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  return has_room_.wait_for(lock, timeout, [this] { return !is_full(); });
}

std::optional<SampleBatch> BatchQueue::pop(std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  has_batch_.wait_for(lock, timeout, [this] { return closed_ || !batches_.empty(); });
  if (batches_.empty()) {
    return std::nullopt;
  }
  SampleBatch batch = std::move(batches_.front());
  batches_.pop_front();
  size_bytes_ -= batch.size_bytes();
  has_room_.notify_one();
  return batch;
}

std::size_t BatchQueue::size_bytes() const {
  const std::lock_guard lock(mutex_);
  return size_bytes_;
}

void BatchQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  has_room_.notify_all();
  has_batch_.notify_all();
  closed_now_.notify_all();
}

bool BatchQueue::wait_for_close(std::chrono::nanoseconds timeout) {
  std::unique_lock lock(mutex_);
  return closed_now_.wait_for(lock, timeout, [this] { return closed_; });
}

bool BatchQueue::finished() const {
  const std::lock_guard lock(mutex_);
  return closed_ && batches_.empty();
}

}  // namespace scarab::logger
