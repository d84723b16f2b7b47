#include "common/bus/stored_type.hpp"

#include <algorithm>
#include <memory>

#include "common/bus/cyclone_log.hpp"
#include "common/bus/error.hpp"
#include "common/bus/made_descriptor.hpp"
#include "common/bus/type_object_walker.hpp"

namespace scarab::bus {

namespace {

Bytes bytes_of(const dds_type_meta_ser& from) {
  const auto* first = reinterpret_cast<const std::byte*>(from.data);
  return {first, first + from.sz};
}

/// Borrows the bytes; Cyclone only reads them.
dds_type_meta_ser borrow(const Bytes& bytes) {
  const auto* first = reinterpret_cast<const unsigned char*>(bytes.data());
  return {const_cast<unsigned char*>(first), static_cast<std::uint32_t>(bytes.size())};
}

/// A descriptor with the stored type information, and the least of everything else: the C layout of
/// the type and the instructions of its serialiser are what is to be found out.
dds_topic_descriptor_t carrier_of(const StoredType& stored) {
  static constexpr std::uint32_t kOneByte[] = {DDS_OP_ADR | DDS_OP_TYPE_1BY, 0, DDS_OP_RTS};
  constexpr std::uint32_t kSize = 1;
  constexpr std::uint32_t kInstructions = 2;
  return {kSize,
          kSize,
          DDS_TOPIC_XTYPES_METADATA,
          0,
          stored.name.c_str(),
          nullptr,
          kInstructions,
          kOneByte,
          "",
          borrow(stored.information),
          borrow(stored.mapping),
          0};
}

struct TypeinfoDeleter {
  void operator()(dds_typeinfo_t* information) const { dds_free_typeinfo(information); }
};
using Typeinfo = std::unique_ptr<dds_typeinfo_t, TypeinfoDeleter>;

}  // namespace

StoredType store_type(const dds_topic_descriptor_t& type) {
  if ((type.m_flagset & DDS_TOPIC_XTYPES_METADATA) == 0) {
    throw Error("type " + std::string(type.m_typename) + ": no type information");
  }
  return {type.m_typename, bytes_of(type.type_information), bytes_of(type.type_mapping)};
}

TopicType restore_type(Participant& participant, const StoredType& stored) {
  const dds_topic_descriptor_t carrier = carrier_of(stored);
  const auto fail = [&](const std::string& why) {
    return Error("type " + stored.name + " cannot be restored: " + why);
  };
  try {
    check_type_objects(carrier);
  } catch (const Error& error) {
    throw fail(error.what());
  }
  const CycloneLog log;
  const auto checked = [&](dds_return_t code) {
    if (code >= 0) return code;
    throw fail(log.text().empty() ? dds_strretcode(code) : log.text());
  };
  // A topic of the carrier's brings the type into the domain's type library, where everything else
  // can be asked for; it has no readers or writers, and is gone at the end.
  const Entity topic(checked(
      dds_create_topic(participant.handle(), &carrier, "scarab/restored_type", nullptr, nullptr)));
  dds_typeinfo_t* found = nullptr;
  checked(dds_get_typeinfo(topic.handle(), &found));
  const Typeinfo information(found);
  dds_topic_descriptor_t* descriptor = nullptr;
  checked(make_descriptor(participant.handle(), DDS_FIND_SCOPE_LOCAL_DOMAIN, *information, 0,
                          &descriptor));
  return own_discovered(descriptor);
}

}  // namespace scarab::bus
