#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "services/robot_bridge/drivers/dynamixel/protocol/bytes.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/control_table.hpp"
#include "services/robot_bridge/drivers/dynamixel/protocol/status.hpp"

namespace scarab::emulator {

namespace dxl = bridge::dynamixel;

/// Who may change a field.
enum class Access {
  kRead,    ///< the device alone
  kRam,     ///< the host, too
  kEeprom,  ///< the host, while the torque is off
};

/// One field of a device's control table.
struct Field {
  dxl::Item item;
  Access access = Access::kRead;
  std::int64_t initial = 0;
  std::int64_t least = 0;  ///< of what the host may write, counts
  std::int64_t most = 0;
};

/// The memory of a device as its bus sees it: fields at addresses, each with who may write it and
/// what. Integers only.
class ControlTable {
 public:
  /// A field on top of another takes its place.
  void add(const Field& field);

  [[nodiscard]] std::int64_t get(const dxl::Item& item) const;
  /// By the device itself: no access, no range.
  void set(const dxl::Item& item, std::int64_t count);
  /// The nearest count to a value in the item's unit.
  void set_value(const dxl::Item& item, double value);

  /// What the host reads; bytes between the fields are 0. None where there is no field at all
  /// (which the device answers with an access error).
  [[nodiscard]] std::optional<dxl::Bytes> read(dxl::Region region) const;

  /// Whether the host may write so (e-Manual, Protocol 2.0, "Error"): kAccess where there is no
  /// field, one that is read-only, or one of the EEPROM while `torque_is_on`; kDataLength where a
  /// field is covered in part; kDataRange for a value outside of its field's.
  [[nodiscard]] dxl::StatusError check(std::uint16_t address, dxl::ByteView data,
                                       bool torque_is_on) const;
  /// After check().
  void write(std::uint16_t address, dxl::ByteView data);

  /// Every field of the RAM is as it is after power-on.
  void reset_ram();

 private:
  [[nodiscard]] dxl::StatusError check_field(const Field& field, dxl::ByteView data,
                                             bool torque_is_on) const;

  std::map<std::uint16_t, Field> fields_;
  std::map<std::uint16_t, std::uint8_t> memory_;
};

}  // namespace scarab::emulator
