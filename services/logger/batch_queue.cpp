#include "services/logger/batch_queue.hpp"

namespace scarab::logger {

bool BatchQueue::push(SampleBatch&& batch) {
  std::unique_lock lock(mutex_);
  has_room_.wait(lock, [this] { return closed_ || size_bytes_ < limit_bytes_; });
  if (closed_) {
    return false;
  }
  size_bytes_ += batch.size_bytes();
  batches_.push_back(std::move(batch));
  has_batch_.notify_one();
  return true;
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

void BatchQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  has_room_.notify_all();
  has_batch_.notify_all();
}

bool BatchQueue::finished() const {
  const std::lock_guard lock(mutex_);
  return closed_ && batches_.empty();
}

}  // namespace scarab::logger
