#include "tools/emulator/boards/dynamixel/control_table.hpp"

#include <algorithm>

namespace scarab::emulator {
namespace {

/// Whether [address, address + size) and the field share a byte.
bool touches(const Field& field, std::size_t address, std::size_t size) {
  const std::size_t begin = field.item.address;
  return begin < address + size && address < begin + field.item.size();
}

}  // namespace

void ControlTable::add(const Field& field) {
  for (auto it = fields_.begin(); it != fields_.end();) {
    it = touches(it->second, field.item.address, field.item.size()) ? fields_.erase(it)
                                                                    : std::next(it);
  }
  fields_[field.item.address] = field;
  set(field.item, field.initial);
}

std::int64_t ControlTable::get(const dxl::Item& item) const {
  dxl::Bytes bytes;
  for (std::size_t i = 0; i < item.size(); ++i) {
    const auto found = memory_.find(static_cast<std::uint16_t>(item.address + i));
    bytes.push_back(found == memory_.end() ? std::uint8_t{0} : found->second);
  }
  return dxl::count_in(item, bytes);
}

void ControlTable::set(const dxl::Item& item, std::int64_t count) {
  write(item.address, dxl::bytes_of(item, count));
}

void ControlTable::set_value(const dxl::Item& item, double value) {
  write(item.address, dxl::bytes_of_value(item, value));
}

std::optional<dxl::Bytes> ControlTable::read(dxl::Region region) const {
  const bool any = std::any_of(fields_.begin(), fields_.end(), [region](const auto& entry) {
    return touches(entry.second, region.address, region.size);
  });
  if (!any) return std::nullopt;
  dxl::Bytes bytes;
  for (std::size_t i = 0; i < region.size; ++i) {
    const auto found = memory_.find(static_cast<std::uint16_t>(region.address + i));
    bytes.push_back(found == memory_.end() ? std::uint8_t{0} : found->second);
  }
  return bytes;
}

dxl::StatusError ControlTable::check_field(const Field& field, dxl::ByteView data,
                                           bool torque_is_on) const {
  if (field.access == Access::kRead) return dxl::StatusError::kAccess;
  if (field.access == Access::kEeprom && torque_is_on) return dxl::StatusError::kAccess;
  const std::int64_t count = dxl::count_in(field.item, data);
  const bool fits = count >= field.least && count <= field.most;
  return fits ? dxl::StatusError::kNone : dxl::StatusError::kDataRange;
}

dxl::StatusError ControlTable::check(std::uint16_t address, dxl::ByteView data,
                                     bool torque_is_on) const {
  std::size_t covered = 0;
  for (const auto& [at, field] : fields_) {
    if (!touches(field, address, data.size())) continue;
    const std::size_t size = field.item.size();
    if (at < address || at + size > address + data.size()) return dxl::StatusError::kDataLength;
    const auto error =
        check_field(field, data.slice(static_cast<std::size_t>(at - address), size), torque_is_on);
    if (error != dxl::StatusError::kNone) return error;
    covered += size;
  }
  return covered == data.size() && covered > 0 ? dxl::StatusError::kNone
                                               : dxl::StatusError::kAccess;
}

void ControlTable::write(std::uint16_t address, dxl::ByteView data) {
  for (std::size_t i = 0; i < data.size(); ++i) {
    memory_[static_cast<std::uint16_t>(address + i)] = data[i];
  }
}

void ControlTable::reset_ram() {
  for (const auto& [at, field] : fields_) {
    if (field.access != Access::kEeprom) set(field.item, field.initial);
  }
}

}  // namespace scarab::emulator
