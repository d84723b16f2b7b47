// Writing topics from bytes: what must get through, and what must not.
#include "common/bus/raw_writer.hpp"

#include <gmock/gmock.h>
#include <wire_types.h>

#include "common/bus/cdr.hpp"
#include "common/bus/error.hpp"
#include "common/bus/reader.hpp"
#include "common/bus/sample_fields.hpp"
#include "common/bus/stored_type.hpp"
#include "common/bus/topics.hpp"
#include "tests/integration/types/any_endpoint.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/support/test_bus.hpp"

namespace scarab::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

constexpr const char* kTopic = "wire/single";

struct RawWriter : testing::Test {
  bus::Participant replay{test_options("replay")};
  bus::Participant plant{test_options("plant")};
  bus::TopicType type = bus::borrow_compiled(wire_Single_desc);

  static sample::Bytes single() {
    const FilledSample sample(wire_Single_desc);
    return bus::encode_sample(wire_Single_desc, sample.get());
  }
};

/// Bytes of a Single that are wrong in one way.
struct Broken {
  const char* name;
  void (*breaks)(sample::Bytes& cdr);
};
void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

// header 0, id 4, paint 8, flag 12, length of tag 16, tag 20, length of few 24, few 28 and 30
const Broken kBroken[] = {
    {"Empty", [](sample::Bytes& cdr) { cdr.clear(); }},
    {"OnlyHeader", [](sample::Bytes& cdr) { cdr.resize(4); }},
    {"HalfHeader", [](sample::Bytes& cdr) { cdr.resize(3); }},
    {"CutInTheMiddle", [](sample::Bytes& cdr) { cdr.resize(16); }},
    {"CutAtTheEnd", [](sample::Bytes& cdr) { cdr.resize(30); }},
    {"ParameterList", [](sample::Bytes& cdr) { cdr[1] = std::byte{3}; }},
    {"NoCdrAtAll", [](sample::Bytes& cdr) { cdr[0] = std::byte{0x42}; }},
    {"OtherByteOrder", [](sample::Bytes& cdr) { cdr[1] = std::byte{0}; }},
    {"EnumBeyondItsLast", [](sample::Bytes& cdr) { cdr[8] = std::byte{99}; }},
    {"NegativeEnum", [](sample::Bytes& cdr) { cdr[11] = std::byte{0xFF}; }},
    {"FlagOfTwo", [](sample::Bytes& cdr) { cdr[12] = std::byte{2}; }},
    {"TextBeyondItsBound", [](sample::Bytes& cdr) { cdr[16] = std::byte{9}; }},
    {"TextWithoutEnd", [](sample::Bytes& cdr) { cdr[23] = std::byte{'x'}; }},
    {"SequenceBeyondItsBound", [](sample::Bytes& cdr) { cdr[24] = std::byte{3}; }},
    {"SequenceBeyondTheBytes", [](sample::Bytes& cdr) { cdr[27] = std::byte{0x10}; }},
};

struct BrokenBytes : RawWriter, testing::WithParamInterface<Broken> {};

TEST_P(BrokenBytes, AreRefusedBeforeTheWire) {
  bus::RawWriter writer(replay, kTopic, type, kept());
  AnyReader reader(plant, kTopic, wire_Single_desc);
  sample::Bytes cdr = single();
  ASSERT_EQ(cdr.size(), 32U);
  GetParam().breaks(cdr);
  EXPECT_THAT([&] { writer.write(cdr); },
              ThrowsMessage<bus::Error>(HasSubstr("writer on wire/single: wire::Single: ")));
  writer.write(single());
  const std::vector<Taken> taken = take_some(reader, 1);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].cdr, single());
}

INSTANTIATE_TEST_SUITE_P(, BrokenBytes, testing::ValuesIn(kBroken),
                         [](const auto& broken) { return broken.param.name; });

TEST_F(RawWriter, NeverCrashesAtFlippedBytes) {
  bus::RawWriter writer(replay, kTopic, type, {});
  const sample::Bytes good = single();
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    sample::Bytes cdr = good;
    cdr[bit / 8] ^= static_cast<std::byte>(1U << bit % 8);
    try {
      writer.write(cdr);
    } catch (const bus::Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0U);
  EXPECT_LT(refused, good.size() * 8);
}

TEST_F(RawWriter, IsReadByATypedReaderWithLongKeys) {
  const bus::StoredType stored = bus::store_type(bus::descriptor<scarab_ServiceStatus>());
  bus::RawWriter writer(replay, bus::kServiceStatus.name, bus::restore_type(replay, stored),
                        kept());
  std::string names[] = {"a service whose name is long, and then: a",
                         "a service whose name is long, and then: b"};
  for (std::string& name : names) {
    scarab_ServiceStatus status{};
    bus::borrow(status.service, name);
    writer.write(bus::encode(status));
  }
  bus::ReaderOptions options;
  options.keep_all = true;
  bus::Reader<scarab_ServiceStatus> reader(plant, {bus::kServiceStatus.name, bus::Profile::kState},
                                           options);
  std::vector<std::string> seen;
  EXPECT_TRUE(eventually([&] {
    reader.take([&](const scarab_ServiceStatus& status) { seen.emplace_back(status.service); });
    return seen.size() == 2;
  }));
  EXPECT_THAT(seen, testing::UnorderedElementsAre(names[0], names[1]));
  EXPECT_THAT(writer.faults(), IsEmpty());
}

TEST_F(RawWriter, SaysWhoReadsAndWhoCannot) {
  bus::RawQos weak;
  weak.reliability = DDS_RELIABILITY_BEST_EFFORT;
  bus::RawWriter writer(replay, kTopic, type, weak);
  AnyReader content(plant, kTopic, wire_Single_desc, weak);
  ASSERT_TRUE(eventually([&] { return writer.matched().size() == 1; }));
  EXPECT_EQ(writer.matched()[0], (bus::Peer{"plant", 0}));
  AnyReader strict(plant, kTopic, wire_Single_desc, {});
  EXPECT_TRUE(eventually([&] { return !writer.faults().empty(); }));
  EXPECT_THAT(writer.faults(), testing::ElementsAre(HasSubstr("reliability")));
}

TEST_F(RawWriter, WritesInTheRepresentationOfItsQos) {
  bus::RawQos qos = kept();
  qos.xcdr2 = true;
  bus::RawWriter writer(replay, kTopic, type, qos);
  AnyReader reader(plant, kTopic, wire_Single_desc, qos);
  writer.write(single());
  const std::vector<Taken> taken = take_some(reader, 1);
  ASSERT_EQ(taken.size(), 1U);
  EXPECT_EQ(taken[0].cdr[1], std::byte{7});  // plain CDR2, little-endian

  bus::RawWriter back(replay, "wire/back", type, kept());
  AnyReader plain(plant, "wire/back", wire_Single_desc);
  back.write(taken[0].cdr);
  const std::vector<Taken> again = take_some(plain, 1);
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].cdr, single());
}

}  // namespace
}  // namespace scarab::test
