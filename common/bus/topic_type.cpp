#include "common/bus/topic_type.hpp"

#include <algorithm>

#include "common/bus/error.hpp"
#include "common/bus/type_object_walker.hpp"

namespace scarab::bus {

namespace {

struct DescriptorDeleter {
  void operator()(dds_topic_descriptor_t* made) const { dds_delete_topic_descriptor(made); }
};
using Made = std::unique_ptr<dds_topic_descriptor_t, DescriptorDeleter>;

/// A discovered descriptor, and its corrected copy that shares all that the first one points to.
struct Corrected {
  Made made;
  dds_topic_descriptor_t copy;
};

bool has_text(const sample::Type& type) {
  const sample::Type& plain = sample::resolve(type);
  if (std::holds_alternative<sample::StringType>(plain.kind)) return true;
  if (const auto* array = std::get_if<sample::ArrayType>(&plain.kind))
    return has_text(*array->element);
  const auto* structure = std::get_if<sample::StructType>(&plain.kind);
  return structure != nullptr &&
         std::any_of(structure->members.begin(), structure->members.end(),
                     [](const sample::Member& member) { return has_text(*member.type); });
}

bool key_has_text(const dds_topic_descriptor_t& descriptor) {
  if (descriptor.m_nkeys == 0) return false;
  try {
    const sample::TypeModel model = model_of(descriptor);
    const auto& members = model.root().members;
    return std::any_of(members.begin(), members.end(), [](const sample::Member& member) {
      return member.key && has_text(*member.type);
    });
  } catch (const Error&) {
    return true;  // a type with parts that TypeModel does not know: without the mark it works as
                  // well
  }
}

}  // namespace

TopicType own_discovered(dds_topic_descriptor_t* descriptor) {
  Made made(descriptor);
  constexpr std::uint32_t kFixedKey = DDS_TOPIC_FIXED_KEY | DDS_TOPIC_FIXED_KEY_XCDR2;
  const dds_topic_descriptor_t& d = *made;
  const std::uint32_t flags = key_has_text(d) ? d.m_flagset & ~kFixedKey : d.m_flagset;
  const dds_topic_descriptor_t copy{
      d.m_size,     d.m_align,          flags,          d.m_nkeys,
      d.m_typename, d.m_keys,           d.m_nops,       d.m_ops,
      d.m_meta,     d.type_information, d.type_mapping, d.restrict_data_representation};
  const auto owner = std::make_shared<Corrected>(Corrected{std::move(made), copy});
  return {owner, &owner->copy};
}

TopicType borrow_compiled(const dds_topic_descriptor_t& compiled) {
  return {&compiled, [](const dds_topic_descriptor_t*) {}};
}

sample::TypeModel model_of(const dds_topic_descriptor_t& descriptor) {
  return sample::TypeModel(walk_type_objects(descriptor));
}

}  // namespace scarab::bus
