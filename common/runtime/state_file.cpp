#include "common/runtime/state_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

namespace scarab::runtime {
namespace {

constexpr std::uint32_t kMagic = 0x53434231;  // "SCB1"
constexpr std::size_t kSlots = 2;
constexpr std::size_t kAlignment = 64;

std::uint32_t crc32(const std::byte* data, std::size_t size, std::uint32_t crc) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1U) ? 0xEDB88320U : 0U);
      entries[i] = value;
    }
    return entries;
  }();
  for (std::size_t i = 0; i < size; ++i) {
    crc = (crc >> 8) ^ table[(crc ^ std::to_integer<std::uint32_t>(data[i])) & 0xFFU];
  }
  return crc;
}

}  // namespace

struct StateFile::Slot {
  std::uint32_t magic;
  std::uint32_t layout;
  std::uint64_t size;
  std::uint64_t sequence;
  std::int64_t tick;
  std::uint32_t trial;
  std::uint32_t crc;  // of all of the slot but this field

  [[nodiscard]] const std::byte* payload() const {
    return reinterpret_cast<const std::byte*>(this) + sizeof(Slot);
  }
  [[nodiscard]] std::uint32_t checksum() const {
    const auto* start = reinterpret_cast<const std::byte*>(this);
    return ~crc32(payload(), size, crc32(start, offsetof(Slot, crc), ~0U));
  }
};

StateFile::StateFile(const std::filesystem::path& path, std::size_t payload_size,
                     std::uint32_t layout)
    : payload_size_(payload_size),
      layout_(layout),
      slot_stride_((sizeof(Slot) + payload_size + kAlignment - 1) / kAlignment * kAlignment) {
  const auto fail = [&path](const char* what) {
    throw std::system_error(errno, std::generic_category(), path.string() + ": " + what);
  };
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) fail("cannot open the state file");
  const auto size = kSlots * slot_stride_;
  if (::ftruncate(file, static_cast<off_t>(size)) != 0) {
    ::close(file);
    fail("cannot size the state file");
  }
  void* memory = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (memory == MAP_FAILED) fail("cannot map the state file");
  memory_ = static_cast<std::byte*>(memory);
  for (std::size_t i = 0; i < kSlots; ++i) {
    if (whole(*slot(i))) sequence_ = std::max(sequence_, slot(i)->sequence);
  }
}

StateFile::~StateFile() { ::munmap(memory_, kSlots * slot_stride_); }

StateFile::Slot* StateFile::slot(std::size_t index) const {
  return reinterpret_cast<Slot*>(memory_ + index * slot_stride_);
}

bool StateFile::whole(const Slot& slot) const {
  return slot.magic == kMagic && slot.layout == layout_ && slot.size == payload_size_ &&
         slot.crc == slot.checksum();
}

std::optional<RecordKey> StateFile::read(void* payload) const {
  const Slot* newest = nullptr;
  for (std::size_t i = 0; i < kSlots; ++i) {
    const Slot* candidate = slot(i);
    if (whole(*candidate) && (!newest || candidate->sequence > newest->sequence)) {
      newest = candidate;
    }
  }
  if (!newest) return std::nullopt;
  std::memcpy(payload, newest->payload(), payload_size_);
  return RecordKey{newest->trial, newest->tick};
}

void StateFile::write(const RecordKey& key, const void* payload) noexcept {
  // Sequence n goes to slot n mod 2: the other slot keeps the record before, whole, until this one
  // is.
  ++sequence_;
  Slot* target = slot(sequence_ % kSlots);
  target->magic = 0;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  target->layout = layout_;
  target->size = payload_size_;
  target->sequence = sequence_;
  target->tick = key.tick;
  target->trial = key.trial;
  std::memcpy(reinterpret_cast<std::byte*>(target) + sizeof(Slot), payload, payload_size_);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  target->magic = kMagic;
  target->crc = target->checksum();
}

}  // namespace scarab::runtime
