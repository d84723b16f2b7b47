#include "common/runtime/state_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

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

std::size_t StateFile::Form::slot_stride() const {
  return (sizeof(Slot) + payload_size + kAlignment - 1) / kAlignment * kAlignment;
}

std::size_t StateFile::Form::file_size() const { return kSlots * slot_stride(); }

bool StateFile::Form::whole(const Slot& slot) const {
  return slot.magic == kMagic && slot.layout == layout && slot.size == payload_size &&
         slot.crc == slot.checksum();
}

const StateFile::Slot* StateFile::Form::newest(const std::byte* memory) const {
  const Slot* newest = nullptr;
  for (std::size_t i = 0; i < kSlots; ++i) {
    const auto* candidate = reinterpret_cast<const Slot*>(memory + i * slot_stride());
    if (whole(*candidate) && (!newest || candidate->sequence > newest->sequence)) {
      newest = candidate;
    }
  }
  return newest;
}

StateFile::StateFile(const std::filesystem::path& path, std::size_t payload_size,
                     std::uint32_t layout)
    : form_{payload_size, layout} {
  const auto fail = [&path](const char* what) {
    throw std::system_error(errno, std::generic_category(), path.string() + ": " + what);
  };
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  if (file < 0) fail("cannot open the state file");
  if (::ftruncate(file, static_cast<off_t>(form_.file_size())) != 0) {
    ::close(file);
    fail("cannot size the state file");
  }
  void* memory = ::mmap(nullptr, form_.file_size(), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (memory == MAP_FAILED) fail("cannot map the state file");
  memory_ = static_cast<std::byte*>(memory);
  if (const Slot* newest = form_.newest(memory_)) sequence_ = newest->sequence;
}

StateFile::~StateFile() { ::munmap(memory_, form_.file_size()); }

std::optional<RecordKey> StateFile::copy(const Form& form, const std::byte* memory, void* payload) {
  const Slot* newest = form.newest(memory);
  if (!newest) return std::nullopt;
  std::memcpy(payload, newest->payload(), form.payload_size);
  return RecordKey{newest->trial, newest->tick};
}

std::optional<RecordKey> StateFile::read(void* payload) const {
  return copy(form_, memory_, payload);
}

std::optional<RecordKey> StateFile::peek(const std::filesystem::path& path,
                                         std::size_t payload_size, std::uint32_t layout,
                                         void* payload) {
  const Form form{payload_size, layout};
  // Judged by a copy: a record that is being written has no right checksum in it.
  std::vector<std::byte> memory(form.file_size() + 1);
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(memory.data()), static_cast<std::streamsize>(memory.size()));
  if (static_cast<std::size_t>(file.gcount()) != form.file_size()) return std::nullopt;
  return copy(form, memory.data(), payload);
}

void StateFile::write(const RecordKey& key, const void* payload) noexcept {
  // Sequence n goes to slot n mod 2: the other slot keeps the record before, whole, until this one
  // is.
  ++sequence_;
  auto* target = reinterpret_cast<Slot*>(memory_ + (sequence_ % kSlots) * form_.slot_stride());
  target->magic = 0;
  std::atomic_signal_fence(std::memory_order_seq_cst);
  target->layout = form_.layout;
  target->size = form_.payload_size;
  target->sequence = sequence_;
  target->tick = key.tick;
  target->trial = key.trial;
  std::memcpy(reinterpret_cast<std::byte*>(target) + sizeof(Slot), payload, form_.payload_size);
  std::atomic_signal_fence(std::memory_order_seq_cst);
  target->magic = kMagic;
  target->crc = target->checksum();
}

}  // namespace scarab::runtime
