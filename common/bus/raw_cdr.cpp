#include "common/bus/raw_cdr.hpp"

#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/q_protocol.h>

#include <algorithm>
#include <array>
#include <string>

#include "common/bus/clock.hpp"
#include "common/bus/error.hpp"
#include "common/sample/encapsulation.hpp"

namespace scarab::bus {

namespace {

constexpr std::size_t kHeaderSize = sample::Encapsulation::kSize;

Error no_sample(const dds_topic_descriptor_t& type, const std::string& why) {
  return Error(std::string(type.m_typename) + ": " + why);
}

/// Serialises into a stream whose memory is freed with it.
class OutputStream {
 public:
  explicit OutputStream(std::uint32_t xcdr_version) {
    dds_ostream_init(&stream_, 512, xcdr_version);
  }
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;
  ~OutputStream() { dds_ostream_fini(&stream_); }

  bool write(const void* sample, const std::uint32_t* ops) {
    return dds_stream_write(&stream_, static_cast<const char*>(sample), ops) != nullptr;
  }
  ByteView bytes() const {
    return {reinterpret_cast<const std::byte*>(stream_.m_buffer), stream_.m_index};
  }

 private:
  dds_ostream_t stream_{};
};

/// The second byte of the encapsulation header, little-endian; the first is 0.
std::byte encapsulation_id(const dds_topic_descriptor_t& type, bool xcdr2) {
  if (!xcdr2) return std::byte{1};  // CDR
  ddsi_sertype_extensibility extensibility = DDSI_SERTYPE_EXT_FINAL;
  dds_stream_extensibility(type.m_ops, &extensibility);
  switch (extensibility) {
    case DDSI_SERTYPE_EXT_FINAL:
      return std::byte{7};  // PLAIN_CDR2
    case DDSI_SERTYPE_EXT_APPENDABLE:
      return std::byte{9};  // DELIMIT_CDR2
    case DDSI_SERTYPE_EXT_MUTABLE:
      return std::byte{11};  // PL_CDR2
  }
  throw no_sample(type, "a type of unknown extensibility");
}

void decode_payload(const dds_topic_descriptor_t& type, ByteView payload, bool swap,
                    std::uint32_t version, void* sample) {
  // Checked and brought into this machine's byte order in place, hence the copy: the stream's own
  // reading has no bounds checks.
  Bytes copy(payload.data, payload.data + payload.size);
  const auto size = static_cast<std::uint32_t>(copy.size());
  std::uint32_t used = 0;
  auto* bytes = reinterpret_cast<char*>(copy.data());
  if (size == 0 ||
      dds_stream_normalize_data(bytes, &used, size, swap, version, type.m_ops) == nullptr) {
    throw Error("bytes that are no sample of it");
  }
  dds_istream_t stream;
  dds_istream_init(&stream, size, copy.data(), version);
  dds_stream_read(&stream, static_cast<char*>(sample), type.m_ops);
}

/// Samples taken from a reader, given back with this object.
class TakenSamples {
 public:
  static constexpr std::uint32_t kMost = 64;

  explicit TakenSamples(dds_entity_t reader)
      : size_(static_cast<std::size_t>(
            check(dds_takecdr(reader, samples_.data(), kMost, infos_.data(), DDS_ANY_STATE),
                  "raw reader"))) {}
  TakenSamples(const TakenSamples&) = delete;
  TakenSamples& operator=(const TakenSamples&) = delete;
  ~TakenSamples() {
    for (std::size_t i = 0; i < size_; ++i) ddsi_serdata_unref(samples_[i]);
  }

  std::size_t size() const { return size_; }
  const ddsi_serdata& sample(std::size_t i) const { return *samples_[i]; }
  const dds_sample_info_t& info(std::size_t i) const { return infos_[i]; }

 private:
  std::array<ddsi_serdata*, kMost> samples_{};
  std::array<dds_sample_info_t, kMost> infos_{};
  std::size_t size_;
};

/// The bytes of a sample where Cyclone keeps them.
class LentBytes {
 public:
  explicit LentBytes(const ddsi_serdata& sample)
      : lender_(ddsi_serdata_to_ser_ref(&sample, 0, ddsi_serdata_size(&sample), &bytes_)) {}
  LentBytes(const LentBytes&) = delete;
  LentBytes& operator=(const LentBytes&) = delete;
  ~LentBytes() { ddsi_serdata_to_ser_unref(lender_, &bytes_); }

  ByteView bytes() const {
    return {static_cast<const std::byte*>(bytes_.iov_base), bytes_.iov_len};
  }

 private:
  ddsrt_iovec_t bytes_{};
  ddsi_serdata* lender_;
};

}  // namespace

Bytes encode_sample(const dds_topic_descriptor_t& type, const void* sample) {
  const bool xcdr2 = dds_stream_minimum_xcdr_version(type.m_ops) == CDR_ENC_VERSION_2;
  OutputStream stream(xcdr2 ? CDR_ENC_VERSION_2 : CDR_ENC_VERSION_1);
  if (!stream.write(sample, type.m_ops)) throw no_sample(type, "a value that is not of its type");
  const ByteView payload = stream.bytes();
  const std::size_t padding = (4 - payload.size % 4) % 4;
  Bytes out(kHeaderSize + payload.size + padding, std::byte{0});
  out[1] = encapsulation_id(type, xcdr2);
  out[3] = static_cast<std::byte>(padding);
  std::copy_n(payload.data, payload.size, out.begin() + kHeaderSize);
  return out;
}

void decode_sample(const dds_topic_descriptor_t& type, ByteView cdr, void* sample) {
  try {
    const sample::Encapsulation encapsulation = sample::encapsulation_of(cdr);
    decode_payload(type, {cdr.data + kHeaderSize, cdr.size - kHeaderSize}, encapsulation.swapped,
                   encapsulation.xcdr2 ? CDR_ENC_VERSION_2 : CDR_ENC_VERSION_1, sample);
  } catch (const Error& error) {
    throw no_sample(type, error.what());
  }
}

void decode_xcdr2(const dds_topic_descriptor_t& type, ByteView payload, void* sample) {
  try {
    decode_payload(type, payload, false, CDR_ENC_VERSION_2, sample);
  } catch (const Error& error) {
    throw no_sample(type, error.what());
  }
}

std::size_t take_raw(dds_entity_t reader, const std::function<void(const RawSample&)>& f,
                     std::size_t enough) {
  std::size_t count = 0;
  while (true) {
    const TakenSamples taken(reader);
    const std::int64_t now = now_ns();
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const dds_sample_info_t& info = taken.info(i);
      if (!info.valid_data) continue;
      const LentBytes lent(taken.sample(i));
      f({lent.bytes(), info.source_timestamp, now, info.publication_handle});
      ++count;
    }
    if (taken.size() < TakenSamples::kMost || count >= enough) return count;
  }
}

}  // namespace scarab::bus
