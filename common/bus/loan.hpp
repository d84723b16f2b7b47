#pragma once

#include <dds/dds.h>

#include <cstddef>
#include <string>

namespace scarab::bus {

/// Up to kCapacity samples lent by Cyclone and returned with this object.
///
/// Every loan has the same capacity on purpose: Cyclone 0.10 fills as many pointers as the reader's
/// largest loan had, and writes beyond a smaller array.
class Loan {
 public:
  static constexpr std::size_t kCapacity = 64;

  /// Takes from a reader; `name` begins the message of an Error.
  static Loan take(dds_entity_t reader, const std::string& name);
  /// Reads, and leaves with the reader, what matches a read condition.
  static Loan read(dds_entity_t condition, const std::string& name);
  /// Reads, and leaves with the reader, the samples of one instance; none if there is no such
  /// instance.
  static Loan read_instance(dds_entity_t reader, dds_instance_handle_t instance,
                            const std::string& name);

  Loan(Loan&& other) noexcept;
  Loan(const Loan&) = delete;
  Loan& operator=(const Loan&) = delete;
  ~Loan();

  std::size_t size() const { return size_; }
  void* sample(std::size_t i) const { return samples_[i]; }
  const dds_sample_info_t& info(std::size_t i) const { return infos_[i]; }

 private:
  explicit Loan(dds_entity_t from) : from_(from) {}

  dds_entity_t from_;
  std::size_t size_ = 0;
  void* samples_[kCapacity] = {};
  dds_sample_info_t infos_[kCapacity] = {};
};

}  // namespace scarab::bus
