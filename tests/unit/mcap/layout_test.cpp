/// A small file, written out by hand from the specification (https://mcap.dev/spec), byte for byte.
/// The CRCs were computed with Python's zlib, so that no line of the library had a part in this.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "common/mcap/reader.hpp"
#include "common/mcap/writer.hpp"
#include "tests/unit/mcap/temporary_folder.hpp"

namespace scarab::mcap::test {
namespace {

// Each record: opcode, length of the content (8 bytes), content.
const char* const kByHand =
    "89 4d 43 41 50 30 0d 0a"                                 // @0   magic
    " 01 0a00000000000000  01000000 70  01000000 6c"          // @8   Header "p" "l"
    " 09 2800000000000000  0500000000000000"                  // @27  Attachment, logged at 5,
    "    0600000000000000  01000000 6e  01000000 6d"          //      created at 6, "n", "m",
    "    0200000000000000 6869  4a988a01"                     //      "hi", CRC
    " 0c 1300000000000000  01000000 4d"                       // @76  Metadata "M",
    "    0a000000  01000000 6b  01000000 76"                  //      10 bytes: "k" -> "v"
    " 06 7f00000000000000  0300000000000000"                  // @104 Chunk, times 3
    "    0300000000000000  5700000000000000"                  //      to 3, 87 bytes,
    "    c7bff52f  00000000  5700000000000000"                //      CRC, "", 87 bytes:
    "      03 1100000000000000  0100"                         //  +0    Schema 1
    "         01000000 53  01000000 65  01000000 64"          //        "S" "e" "d"
    "      04 1400000000000000  0100 0100"                    //  +26   Channel 1 of schema 1
    "         01000000 74  03000000 636472  00000000"         //        "t" "cdr" {}
    "      05 1700000000000000  0100  02000000"               //  +55   Message on 1, number 2,
    "         0300000000000000  0400000000000000  ab"         //        times 3 and 4, one byte
    " 07 1600000000000000  0100  10000000"                    // @240 MessageIndex of channel 1:
    "    0300000000000000  3700000000000000"                  //      time 3 is at +55
    " 0f 0400000000000000  f112c2f4"                          // @271 DataEnd, CRC of bytes 0..270
    " 03 1100000000000000  0100"                              // @284 Schema
    "    01000000 53  01000000 65  01000000 64"               //
    " 04 1400000000000000  0100 0100"                         // @310 Channel
    "    01000000 74  03000000 636472  00000000"              //
    " 0b 3800000000000000  0100000000000000  0100  01000000"  // @339 Statistics: 1 message, 1
                                                              // schema,
    "    01000000  01000000  01000000  0300000000000000"    //      1 channel, attachment, metadata,
    "    0300000000000000  0a000000 0100 0100000000000000"  //      chunk; 3 to 3; channel 1 has 1
    " 08 4a00000000000000  0300000000000000"                // @404 ChunkIndex, 3
    "    0300000000000000  6800000000000000"                //      to 3, at 104,
    "    8800000000000000  0a000000 0100 f000000000000000"  //      136 long, index of 1 at 240,
    "    1f00000000000000  00000000"                        //      31 long, "",
    "    5700000000000000  5700000000000000"                //      87 from 87 bytes
    " 0a 3200000000000000  1b00000000000000"                // @487 AttachmentIndex, at 27,
    "    3100000000000000  0500000000000000"                //      49 long, 5,
    "    0600000000000000  0200000000000000"                //      6, 2 bytes,
    "    01000000 6e  01000000 6d"                          //      "n" "m"
    " 0d 1500000000000000  4c00000000000000"                // @546 MetadataIndex, at 76,
    "    1c00000000000000  01000000 4d"                     //      28 long, "M"
    " 0e 1100000000000000  03 1c01000000000000 1a00000000000000"  // @576 SummaryOffset, Schema
    " 0e 1100000000000000  04 3601000000000000 1d00000000000000"  //      Channel
    " 0e 1100000000000000  0b 5301000000000000 4100000000000000"  //      Statistics
    " 0e 1100000000000000  08 9401000000000000 5300000000000000"  //      ChunkIndex
    " 0e 1100000000000000  0a e701000000000000 3b00000000000000"  //      AttachmentIndex
    " 0e 1100000000000000  0d 2202000000000000 1e00000000000000"  //      MetadataIndex
    " 02 1400000000000000  1c01000000000000"                      // @732 Footer: summary at 284,
    "    4002000000000000  6760a7ef"  //      offsets at 576, CRC of 284..756
    " 89 4d 43 41 50 30 0d 0a";       // magic

Bytes from_hex(const std::string& text) {
  std::string digits;
  std::copy_if(text.begin(), text.end(), std::back_inserter(digits),
               [](char c) { return c != ' '; });
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(digits.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

TEST(Layout, OfAWrittenFileIsTheSpecifications) {
  TemporaryFolder folder;
  WriterOptions options;
  options.compression = Compression::kNone;
  options.profile = "p";
  options.library = "l";
  Writer writer(folder / "x.mcap", options);
  writer.attach({5, 6, "n", "m", {'h', 'i'}});
  writer.add_metadata({"M", {{"k", "v"}}});
  const auto channel = writer.add_channel(writer.add_schema("S", "e", "d"), "t", "cdr");
  const Bytes data{0xAB};
  writer.write({channel, 2, 3, 4, data});
  writer.close();
  EXPECT_EQ(read_file(folder / "x.mcap"), from_hex(kByHand));
}

TEST(Layout, WrittenByHandIsRead) {
  TemporaryFolder folder;
  write_file(folder / "x.mcap", from_hex(kByHand));
  const Reader reader(folder / "x.mcap");
  EXPECT_TRUE(reader.closed());
  EXPECT_EQ(reader.damage(), "");
  EXPECT_EQ(reader.header().profile, "p");
  std::size_t count = 0;
  reader.for_each([&](const Channel& channel, const Message& message) {
    EXPECT_EQ(channel.topic, "t");
    EXPECT_EQ(message.sequence, 2U);
    EXPECT_EQ(message.log_time_ns, 3U);
    EXPECT_EQ(message.publish_time_ns, 4U);
    EXPECT_EQ(copy_of(message.data), Bytes{0xAB});
    ++count;
  });
  EXPECT_EQ(count, 1U);
}

}  // namespace
}  // namespace scarab::mcap::test
