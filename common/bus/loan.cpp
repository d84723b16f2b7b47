#include "common/bus/loan.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "common/bus/error.hpp"

namespace scarab::bus {

Loan Loan::take(dds_entity_t reader, const std::string& name) {
  Loan loan(reader);
  const int code = dds_take(reader, loan.samples_, loan.infos_, kCapacity, kCapacity);
  loan.size_ = static_cast<std::size_t>(check(code, name));
  return loan;
}

Loan Loan::read(dds_entity_t condition, const std::string& name) {
  Loan loan(condition);
  const int code = dds_read(condition, loan.samples_, loan.infos_, kCapacity, kCapacity);
  loan.size_ = static_cast<std::size_t>(check(code, name));
  return loan;
}

Loan Loan::read_instance(dds_entity_t reader, dds_instance_handle_t instance,
                         const std::string& name) {
  Loan loan(reader);
  const int code =
      dds_read_instance(reader, loan.samples_, loan.infos_, kCapacity, kCapacity, instance);
  if (code == DDS_RETCODE_PRECONDITION_NOT_MET) return loan;
  loan.size_ = static_cast<std::size_t>(check(code, name));
  return loan;
}

Loan::Loan(Loan&& other) noexcept : from_(other.from_), size_(std::exchange(other.size_, 0)) {
  std::copy_n(other.samples_, size_, samples_);
  std::copy_n(other.infos_, size_, infos_);
}

Loan::~Loan() {
  if (size_ > 0) dds_return_loan(from_, samples_, static_cast<std::int32_t>(size_));
}

}  // namespace scarab::bus
