#include "common/mcap/summary.hpp"

#include "common/mcap/crc32.hpp"
#include "common/mcap/decode.hpp"
#include "common/mcap/encode.hpp"

namespace scarab::mcap {
namespace {

/// Writes groups of records of one opcode and remembers where each is.
class GroupWriter {
 public:
  GroupWriter(Bytes& out, std::uint64_t start) : out_(out), start_(start) {}

  template <class Id, class Record>
  void write(Opcode opcode, const std::map<Id, Record>& records) {
    const std::size_t before = out_.size();
    for (const auto& [id, record] : records) {
      encode(out_, record);
    }
    remember(opcode, before);
  }

  template <class Record>
  void write(Opcode opcode, const std::vector<Record>& records) {
    const std::size_t before = out_.size();
    for (const Record& record : records) {
      encode(out_, record);
    }
    remember(opcode, before);
  }

  void write_offsets() const {
    for (const SummaryOffset& group : groups_) {
      encode(out_, group);
    }
  }

 private:
  void remember(Opcode opcode, std::size_t before) {
    if (out_.size() > before) {
      groups_.push_back({opcode, start_ + before, out_.size() - before});
    }
  }

  Bytes& out_;
  std::uint64_t start_;
  std::vector<SummaryOffset> groups_;
};

}  // namespace

Bytes encode_summary(const Summary& summary, std::uint64_t start) {
  Bytes out;
  GroupWriter groups(out, start);
  groups.write(Opcode::kSchema, summary.schemas);
  groups.write(Opcode::kChannel, summary.channels);
  groups.write(Opcode::kStatistics, std::vector<Statistics>{summary.statistics});
  groups.write(Opcode::kChunkIndex, summary.chunks);
  groups.write(Opcode::kAttachmentIndex, summary.attachments);
  groups.write(Opcode::kMetadataIndex, summary.metadata);

  Footer footer{start, start + out.size(), 0};
  groups.write_offsets();
  Crc32 crc;
  crc.update(out);
  crc.update(footer_before_crc(footer));
  footer.summary_crc = crc.value();
  encode(out, footer);
  out.insert(out.end(), kMagic.begin(), kMagic.end());
  return out;
}

Summary decode_summary(ByteView records) {
  Summary summary;
  RecordCursor cursor(records);
  while (cursor.next()) {
    if (cursor.opcode() == Opcode::kSchema) {
      Schema schema = decode_schema(cursor.content());
      summary.schemas[schema.id] = std::move(schema);
    } else if (cursor.opcode() == Opcode::kChannel) {
      Channel channel = decode_channel(cursor.content());
      summary.channels[channel.id] = std::move(channel);
    } else if (cursor.opcode() == Opcode::kStatistics) {
      summary.statistics = decode_statistics(cursor.content());
    } else if (cursor.opcode() == Opcode::kChunkIndex) {
      summary.chunks.push_back(decode_chunk_index(cursor.content()));
    } else if (cursor.opcode() == Opcode::kAttachmentIndex) {
      summary.attachments.push_back(decode_attachment_index(cursor.content()));
    } else if (cursor.opcode() == Opcode::kMetadataIndex) {
      summary.metadata.push_back(decode_metadata_index(cursor.content()));
    }
  }
  return summary;
}

}  // namespace scarab::mcap
