#include "common/bus/made_descriptor.hpp"

#include <dds/ddsi/ddsi_sertype.h>  // what the next one needs and does not include
#include <dds/ddsi/ddsi_typelib.h>
#include <dds/ddsi/ddsi_xt_impl.h>
#include <dds/ddsi/ddsi_xt_typeinfo.h>

#include <algorithm>
#include <cstddef>
#include <memory>

#include "common/bus/sample_fields.hpp"

namespace scarab::bus {

namespace {

using TypeIdentifier = DDS_XTypes_TypeIdentifier;

struct TypeobjDeleter {
  void operator()(dds_typeobj_t* object) const { dds_free_typeobj(object); }
};
using Typeobj = std::unique_ptr<dds_typeobj_t, TypeobjDeleter>;

/// Counts the keys of a type as Cyclone does, down to the members that are no structs.
class KeyCount {
 public:
  KeyCount(dds_entity_t participant, dds_duration_t timeout)
      : participant_(participant), timeout_(timeout) {}

  /// `is_key`: the type is that of a key member.
  dds_return_t add(const TypeIdentifier& id, bool is_key) {
    if (id._d != DDS_XTypes_EK_COMPLETE) {
      keys_ += is_key ? 1U : 0U;
      return DDS_RETCODE_OK;
    }
    if (++depth_ > kMostLevels) return DDS_RETCODE_UNSUPPORTED;
    dds_typeobj_t* found = nullptr;
    const dds_return_t code =
        dds_get_typeobj(participant_, reinterpret_cast<const dds_typeid_t*>(&id), timeout_, &found);
    if (code != DDS_RETCODE_OK) return code;
    const Typeobj object(found);
    const dds_return_t result = add(found->x._u.complete, is_key);
    --depth_;
    return result;
  }

  bool ends_the_process() const { return in_base_ && keys_ > 1; }

 private:
  static constexpr std::size_t kMostLevels = 64;

  dds_return_t add(const DDS_XTypes_CompleteTypeObject& object, bool is_key) {
    if (object._d == DDS_XTypes_TK_STRUCTURE) return add(object._u.struct_type, is_key);
    if (object._d == DDS_XTypes_TK_ALIAS) {
      return add(object._u.alias_type.body.common.related_type, is_key);
    }
    keys_ += is_key ? 1U : 0U;
    return DDS_RETCODE_OK;
  }

  dds_return_t add(const DDS_XTypes_CompleteStructType& type, bool is_key) {
    const std::size_t before = keys_;
    if (type.header.base_type._d != DDS_XTypes_TK_NONE) {
      const dds_return_t code = add(type.header.base_type, is_key);
      if (code != DDS_RETCODE_OK) return code;
      in_base_ = in_base_ || keys_ > before;
    }
    const auto members = elements(type.member_seq);
    const auto marked = [](const auto& member) {
      return (member.common.member_flags & DDS_XTypes_IS_KEY) != 0;
    };
    // In a struct that is a key, all members are, unless some are marked.
    const bool all = is_key && std::none_of(members.begin(), members.end(), marked);
    for (const auto& member : members) {
      if (!all && !marked(member)) continue;
      const dds_return_t code = add(member.common.member_type_id, true);
      if (code != DDS_RETCODE_OK) return code;
    }
    return DDS_RETCODE_OK;
  }

  dds_entity_t participant_;
  dds_duration_t timeout_;
  std::size_t keys_ = 0;
  bool in_base_ = false;
  std::size_t depth_ = 0;
};

/// Asks for the types that a type is made of one by one. Cyclone 0.10 asks for all at once, counts
/// one that is used at two depths twice, and sends what happens to be in memory for the second.
dds_return_t fetch_dependencies(dds_entity_t participant, const dds_typeinfo_t& information,
                                dds_duration_t timeout) {
  for (const auto& dependency : elements(information.x.complete.dependent_typeids)) {
    const TypeIdentifier& id = dependency.type_id;
    if (id._d != DDS_XTypes_EK_COMPLETE) continue;
    dds_typeobj_t* found = nullptr;
    const dds_return_t code =
        dds_get_typeobj(participant, reinterpret_cast<const dds_typeid_t*>(&id), timeout, &found);
    if (code != DDS_RETCODE_OK) return code;
    const Typeobj object(found);
  }
  return DDS_RETCODE_OK;
}

}  // namespace

dds_return_t make_descriptor(dds_entity_t participant, dds_find_scope_t scope,
                             const dds_typeinfo_t& information, dds_duration_t timeout,
                             dds_topic_descriptor_t** made) {
  KeyCount keys(participant, timeout);
  const dds_return_t code = keys.add(information.x.complete.typeid_with_size.type_id, false);
  if (code != DDS_RETCODE_OK) return code;
  if (keys.ends_the_process()) return DDS_RETCODE_UNSUPPORTED;
  const dds_return_t fetched = fetch_dependencies(participant, information, timeout);
  if (fetched != DDS_RETCODE_OK) return fetched;
  return dds_create_topic_descriptor(scope, participant, &information, timeout, made);
}

}  // namespace scarab::bus
