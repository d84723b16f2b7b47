#include "common/bus/raw_cdr.hpp"

#include <dds/ddsi/ddsi_cdrstream.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/q_protocol.h>

#include <algorithm>
#include <array>
#include <string>

#include "common/bus/clock.hpp"
#include "common/bus/encapsulation.hpp"
#include "common/bus/error.hpp"

namespace scarab::bus {

namespace {

constexpr std::size_t kHeaderSize = Encapsulation::kSize;

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
  return std::byte{extensibility == DDSI_SERTYPE_EXT_APPENDABLE ? std::uint8_t{9}    // DELIMIT_CDR2
                                                                : std::uint8_t{7}};  // PLAIN_CDR2
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
    const Encapsulation encapsulation = encapsulation_of(cdr);
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

std::size_t take_raw(dds_entity_t reader, const std::function<void(const RawSample&)>& f) {
  constexpr std::uint32_t kBatch = 64;
  std::size_t count = 0;
  Bytes bytes;
  while (true) {
    std::array<ddsi_serdata*, kBatch> samples{};
    std::array<dds_sample_info_t, kBatch> infos{};
    const int taken = check(
        dds_takecdr(reader, samples.data(), kBatch, infos.data(), DDS_ANY_STATE), "raw reader");
    const std::int64_t now = now_ns();
    for (std::size_t i = 0; i < static_cast<std::size_t>(taken); ++i) {
      bytes.resize(ddsi_serdata_size(samples[i]));
      ddsi_serdata_to_ser(samples[i], 0, bytes.size(), bytes.data());
      ddsi_serdata_unref(samples[i]);
      if (!infos[i].valid_data) continue;
      f({bytes, infos[i].source_timestamp, now, infos[i].publication_handle});
      ++count;
    }
    if (static_cast<std::uint32_t>(taken) < kBatch) return count;
  }
}

}  // namespace scarab::bus
