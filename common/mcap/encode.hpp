#pragma once

#include <utility>
#include <vector>

#include "common/mcap/records.hpp"

/// Records to bytes: each function appends one whole record (opcode, length, content),
/// little-endian.
namespace scarab::mcap {

void encode(Bytes& out, const Header& record);
void encode(Bytes& out, const Footer& record);
void encode(Bytes& out, const Schema& record);
void encode(Bytes& out, const Channel& record);
void encode(Bytes& out, const Message& record);
void encode(Bytes& out, const Chunk& record);
void encode(Bytes& out, const ChunkIndex& record);
/// With the CRC-32 of the fields before it.
void encode(Bytes& out, const Attachment& record);
void encode(Bytes& out, const AttachmentIndex& record);
void encode(Bytes& out, const Metadata& record);
void encode(Bytes& out, const MetadataIndex& record);
void encode(Bytes& out, const Statistics& record);
void encode(Bytes& out, const SummaryOffset& record);

/// Log time and offset in the uncompressed chunk of each message of one channel.
using MessageOffsets = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
void encode_message_index(Bytes& out, std::uint16_t channel_id, const MessageOffsets& entries);

/// `data_section_crc`: of all bytes of the file before this record.
void encode_data_end(Bytes& out, std::uint32_t data_section_crc);

/// The bytes of a footer up to its last field: what the summary's CRC covers of it.
Bytes footer_before_crc(const Footer& footer);

}  // namespace scarab::mcap
