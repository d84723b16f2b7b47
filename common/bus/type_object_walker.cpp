#include "common/bus/type_object_walker.hpp"

#include <dds/ddsi/ddsi_sertype.h>  // what the next one needs and does not include
#include <dds/ddsi/ddsi_typelib.h>
#include <dds/ddsi/ddsi_xt_impl.h>
#include <dds/ddsi/ddsi_xt_typeinfo.h>
#include <dds/ddsi/ddsi_xt_typemap.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

#include "common/bus/error.hpp"
#include "common/bus/raw_cdr.hpp"
#include "common/bus/sample_fields.hpp"

namespace scarab::bus {

namespace {

using TypeIdentifier = DDS_XTypes_TypeIdentifier;
using Hash = std::string;

/// A structure of the XTypes standard, decoded from a descriptor and freed with this object.
template <class T>
class Decoded {
 public:
  Decoded(const dds_topic_descriptor_t& type, const dds_type_meta_ser& bytes) : type_(type) {
    decode_xcdr2(type, {reinterpret_cast<const std::byte*>(bytes.data), bytes.sz}, &value_);
  }
  Decoded(const Decoded&) = delete;
  Decoded& operator=(const Decoded&) = delete;
  ~Decoded() { dds_sample_free(&value_, &type_, DDS_FREE_CONTENTS); }

  const T& operator*() const { return value_; }
  const T* operator->() const { return &value_; }

 private:
  const dds_topic_descriptor_t& type_;
  T value_{};
};

Hash hash_of(const TypeIdentifier& id) {
  const auto& bytes = id._u.equivalence_hash;
  return {reinterpret_cast<const char*>(bytes), sizeof(bytes)};
}

sample::TypeRef make(decltype(sample::Type::kind) kind) {
  return std::make_shared<const sample::Type>(sample::Type{std::move(kind)});
}

template <class Bounds>
std::vector<std::uint32_t> dimensions(const Bounds& bounds) {
  return {bounds._buffer, bounds._buffer + bounds._length};
}

/// Follows type identifiers through the type map of one descriptor.
class Walker {
 public:
  Walker(std::string topic_type, const DDS_XTypes_TypeMapping& map)
      : topic_type_(std::move(topic_type)) {
    for (const auto& pair : elements(map.identifier_object_pair_complete)) {
      objects_[hash_of(pair.type_identifier)] = &pair.type_object._u.complete;
    }
  }

  sample::TypeRef type_of(const TypeIdentifier& id);

 private:
  sample::TypeRef named(const TypeIdentifier& id);
  sample::TypeRef struct_type(const DDS_XTypes_CompleteStructType& from);
  sample::TypeRef enum_type(const DDS_XTypes_CompleteEnumeratedType& from);
  sample::TypeRef object_type(const DDS_XTypes_CompleteTypeObject& object);
  Error unsupported(const std::string& what) const {
    return Error("type " + topic_type_ + ": " + what + " not supported");
  }

  std::string topic_type_;
  std::map<Hash, const DDS_XTypes_CompleteTypeObject*> objects_;
  std::map<Hash, sample::TypeRef> done_;
};

const std::map<int, sample::Primitive>& primitives() {
  static const std::map<int, sample::Primitive> kinds{
      {DDS_XTypes_TK_BOOLEAN, sample::Primitive::kBoolean},
      {DDS_XTypes_TK_BYTE, sample::Primitive::kOctet},
      {DDS_XTypes_TK_CHAR8, sample::Primitive::kChar},
      {DDS_XTypes_TK_INT16, sample::Primitive::kInt16},
      {DDS_XTypes_TK_INT32, sample::Primitive::kInt32},
      {DDS_XTypes_TK_INT64, sample::Primitive::kInt64},
      {DDS_XTypes_TK_UINT16, sample::Primitive::kUint16},
      {DDS_XTypes_TK_UINT32, sample::Primitive::kUint32},
      {DDS_XTypes_TK_UINT64, sample::Primitive::kUint64},
      {DDS_XTypes_TK_FLOAT32, sample::Primitive::kFloat},
      {DDS_XTypes_TK_FLOAT64, sample::Primitive::kDouble}};
  return kinds;
}

/// What TypeModel has no place for, by the kind of a type identifier or type object.
std::string construct_name(int kind) {
  static const std::map<int, const char*> names{
      {DDS_XTypes_TK_UNION, "union"},
      {DDS_XTypes_TK_BITMASK, "bitmask"},
      {DDS_XTypes_TK_BITSET, "bitset"},
      {DDS_XTypes_TK_MAP, "map"},
      {DDS_XTypes_TI_PLAIN_MAP_SMALL, "map"},
      {DDS_XTypes_TI_PLAIN_MAP_LARGE, "map"},
      {DDS_XTypes_TI_STRING16_SMALL, "wide string"},
      {DDS_XTypes_TI_STRING16_LARGE, "wide string"},
      {DDS_XTypes_TK_CHAR16, "wide character"},
      {DDS_XTypes_TK_FLOAT128, "long double"},
      {DDS_XTypes_TI_STRONGLY_CONNECTED_COMPONENT, "type that contains itself"}};
  const auto found = names.find(kind);
  return found == names.end() ? "type kind " + std::to_string(kind) : found->second;
}

std::string construct_name(const DDS_XTypes_CompleteTypeObject& object) {
  const std::string kind = construct_name(object._d) + " ";
  if (object._d == DDS_XTypes_TK_UNION) {
    return kind + object._u.union_type.header.detail.type_name;
  }
  if (object._d == DDS_XTypes_TK_BITMASK) {
    return kind + object._u.bitmask_type.header.detail.type_name;
  }
  return construct_name(object._d);
}

sample::TypeRef Walker::type_of(const TypeIdentifier& id) {
  const auto primitive = primitives().find(id._d);
  if (primitive != primitives().end()) return make(primitive->second);
  const auto& u = id._u;
  switch (id._d) {
    case DDS_XTypes_TI_STRING8_SMALL:
      return make(sample::StringType{u.string_sdefn.bound});
    case DDS_XTypes_TI_STRING8_LARGE:
      return make(sample::StringType{u.string_ldefn.bound});
    case DDS_XTypes_TI_PLAIN_SEQUENCE_SMALL:
      return make(
          sample::SequenceType{type_of(*u.seq_sdefn.element_identifier), u.seq_sdefn.bound});
    case DDS_XTypes_TI_PLAIN_SEQUENCE_LARGE:
      return make(
          sample::SequenceType{type_of(*u.seq_ldefn.element_identifier), u.seq_ldefn.bound});
    case DDS_XTypes_TI_PLAIN_ARRAY_SMALL:
      return make(sample::ArrayType{type_of(*u.array_sdefn.element_identifier),
                                    dimensions(u.array_sdefn.array_bound_seq)});
    case DDS_XTypes_TI_PLAIN_ARRAY_LARGE:
      return make(sample::ArrayType{type_of(*u.array_ldefn.element_identifier),
                                    dimensions(u.array_ldefn.array_bound_seq)});
    case DDS_XTypes_EK_COMPLETE:
      return named(id);
    default:
      throw unsupported(construct_name(id._d));
  }
}

sample::TypeRef Walker::named(const TypeIdentifier& id) {
  const Hash hash = hash_of(id);
  sample::TypeRef& known = done_[hash];
  if (known) return known;
  const auto object = objects_.find(hash);
  if (object == objects_.end()) throw unsupported("incomplete type information");
  sample::TypeRef made = object_type(*object->second);
  return done_[hash] = std::move(made);
}

sample::TypeRef Walker::object_type(const DDS_XTypes_CompleteTypeObject& object) {
  switch (object._d) {
    case DDS_XTypes_TK_STRUCTURE:
      return struct_type(object._u.struct_type);
    case DDS_XTypes_TK_ENUM:
      return enum_type(object._u.enumerated_type);
    case DDS_XTypes_TK_ALIAS: {
      const auto& alias = object._u.alias_type;
      return make(sample::AliasType{alias.header.detail.type_name,
                                    type_of(alias.body.common.related_type)});
    }
    case DDS_XTypes_TK_SEQUENCE: {
      const auto& sequence = object._u.sequence_type;
      return make(sample::SequenceType{type_of(sequence.element.common.type),
                                       sequence.header.common.bound});
    }
    case DDS_XTypes_TK_ARRAY: {
      const auto& array = object._u.array_type;
      return make(sample::ArrayType{type_of(array.element.common.type),
                                    dimensions(array.header.common.bound_seq)});
    }
    default:
      throw unsupported(construct_name(object));
  }
}

sample::TypeRef Walker::struct_type(const DDS_XTypes_CompleteStructType& from) {
  sample::StructType out{from.header.detail.type_name, {}};
  if ((from.struct_flags & DDS_XTypes_IS_MUTABLE) != 0) {
    throw unsupported("mutable struct " + out.name);
  }
  if ((from.struct_flags & DDS_XTypes_IS_APPENDABLE) != 0) {
    out.extensibility = sample::Extensibility::kAppendable;
  }
  if (from.header.base_type._d != DDS_XTypes_TK_NONE) {
    // On the wire the members of a base are just the first ones.
    const sample::TypeRef base = type_of(from.header.base_type);
    const auto* structure = std::get_if<sample::StructType>(&sample::resolve(*base).kind);
    if (structure == nullptr) throw unsupported("base of " + out.name);
    out.members = structure->members;
  }
  for (const auto& member : elements(from.member_seq)) {
    const unsigned flags = member.common.member_flags;
    if ((flags & DDS_XTypes_IS_OPTIONAL) != 0) {
      throw unsupported(std::string("optional member ") + member.detail.name);
    }
    out.members.push_back({member.detail.name, type_of(member.common.member_type_id),
                           (flags & DDS_XTypes_IS_KEY) != 0});
  }
  return make(std::move(out));
}

sample::TypeRef Walker::enum_type(const DDS_XTypes_CompleteEnumeratedType& from) {
  sample::EnumType out{from.header.detail.type_name, {}};
  if (from.header.common.bit_bound > 32 || from.header.common.bit_bound <= 16) {
    throw unsupported("enum " + out.name + " of " + std::to_string(from.header.common.bit_bound) +
                      " bits");
  }
  for (const auto& literal : elements(from.literal_seq)) {
    out.literals.push_back({literal.detail.name, literal.common.value});
  }
  return make(std::move(out));
}

/// The two parts of a descriptor's type information.
struct TypeObjects {
  explicit TypeObjects(const dds_topic_descriptor_t& descriptor)
      : information(DDS_XTypes_TypeInformation_desc, metadata_of(descriptor).type_information),
        map(DDS_XTypes_TypeMapping_desc, descriptor.type_mapping) {}

  static const dds_topic_descriptor_t& metadata_of(const dds_topic_descriptor_t& descriptor) {
    const bool present = (descriptor.m_flagset & DDS_TOPIC_XTYPES_METADATA) != 0;
    if (present) return descriptor;
    throw Error("type " + std::string(descriptor.m_typename) + ": no type information");
  }

  Decoded<DDS_XTypes_TypeInformation> information;
  Decoded<DDS_XTypes_TypeMapping> map;
};

/// True if the objects are those their identifiers say, and the type itself is among them.
template <class Pairs>
bool holds(const Pairs& pairs, const DDS_XTypes_TypeIdentifierWithDependencies& type) {
  const Hash wanted = hash_of(type.typeid_with_size.type_id);
  bool found = false;
  for (const auto& pair : elements(pairs)) {
    ddsi_typeid_t computed{};
    if (ddsi_typeobj_get_hash_id(&pair.type_object, &computed) != DDS_RETCODE_OK) return false;
    const Hash hash = hash_of(pair.type_identifier);
    if (computed.x._d != pair.type_identifier._d || hash_of(computed.x) != hash) return false;
    found = found || (hash == wanted && computed.x._d == type.typeid_with_size.type_id._d);
  }
  return found;
}

}  // namespace

sample::TypeRef walk_type_objects(const dds_topic_descriptor_t& descriptor) {
  const TypeObjects found(descriptor);
  return Walker(descriptor.m_typename, *found.map)
      .type_of(found.information->complete.typeid_with_size.type_id);
}

void check_type_objects(const dds_topic_descriptor_t& descriptor) {
  const TypeObjects found(descriptor);
  const auto& map = *found.map;
  const bool whole = holds(map.identifier_object_pair_minimal, found.information->minimal) &&
                     holds(map.identifier_object_pair_complete, found.information->complete);
  if (!whole) throw Error("damaged type information");
}

}  // namespace scarab::bus
