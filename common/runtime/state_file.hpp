#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <type_traits>

namespace scarab::runtime {

/// Where a record stands in its run.
struct RecordKey {
  std::uint32_t trial = 0;
  std::int64_t tick = -1;  ///< last tick answered; -1 none
};

/// A small memory-mapped file that always holds the last whole record written, whenever the process
/// is killed: two slots, each with sequence number and CRC-32, written in turn. It guards against
/// the death of the process, not of the machine (nothing is synced to the disk).
class StateFile {
 public:
  /// Opens or makes `path` for records of `payload_size` bytes. `layout` names the payload's
  /// layout: a file of another layout or size is begun anew. Throws std::system_error naming the
  /// path.
  StateFile(const std::filesystem::path& path, std::size_t payload_size, std::uint32_t layout);
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  /// Reads another process's file, which may be writing it: its newest whole record, as read().
  /// Nothing, too, if there is no such file or its records are others'. Never changes the file.
  static std::optional<RecordKey> peek(const std::filesystem::path& path, std::size_t payload_size,
                                       std::uint32_t layout, void* payload);

  /// The newest whole record: its payload is copied to `payload`; nothing if there is none.
  std::optional<RecordKey> read(void* payload) const;
  void write(const RecordKey& key, const void* payload) noexcept;

 private:
  struct Slot;
  /// What a record must be to be ours.
  struct Form {
    std::size_t payload_size;
    std::uint32_t layout;

    [[nodiscard]] std::size_t slot_stride() const;
    [[nodiscard]] std::size_t file_size() const;
    [[nodiscard]] bool whole(const Slot& slot) const;
    /// In all of a file; nullptr if there is none.
    [[nodiscard]] const Slot* newest(const std::byte* memory) const;
  };
  static std::optional<RecordKey> copy(const Form& form, const std::byte* memory, void* payload);

  Form form_;
  std::byte* memory_ = nullptr;
  std::uint64_t sequence_ = 0;
};

/// StateFile of one trivially copyable type.
template <class Payload>
class TypedStateFile {
  static_assert(std::is_trivially_copyable_v<Payload>);

 public:
  TypedStateFile(const std::filesystem::path& path, std::uint32_t layout)
      : file_(path, sizeof(Payload), layout) {}
  static std::optional<RecordKey> peek(const std::filesystem::path& path, std::uint32_t layout,
                                       Payload& payload) {
    return StateFile::peek(path, sizeof(Payload), layout, &payload);
  }
  std::optional<RecordKey> read(Payload& payload) const { return file_.read(&payload); }
  void write(const RecordKey& key, const Payload& payload) noexcept { file_.write(key, &payload); }

 private:
  StateFile file_;
};

}  // namespace scarab::runtime
