#pragma once

#include <dds/dds.h>

#include <memory>
#include <utility>

namespace scarab::bus {

/// Owns one Cyclone DDS entity: deleted with this object. Movable, not copyable.
class Entity {
 public:
  Entity() = default;
  explicit Entity(dds_entity_t handle) : handle_(handle) {}
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  Entity(const Entity&) = delete;
  Entity& operator=(const Entity&) = delete;
  ~Entity() {
    if (handle_ > 0) dds_delete(handle_);
  }

  dds_entity_t handle() const { return handle_; }

 private:
  dds_entity_t handle_ = 0;
};

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};

/// An owned set of QoS policies.
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;

}  // namespace scarab::bus
