#include "common/bus/compatibility.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include "common/bus/policy_text.hpp"

namespace scarab::bus {

namespace {

using Found = std::optional<Mismatch>;

/// Kinds are declared from the weakest to the strongest: who asks for more than is offered gets
/// nothing.
template <class Kind>
Found weaker(const char* policy, Kind offered, Kind asked) {
  if (offered >= asked) return {};
  return Mismatch{policy, to_text(offered), to_text(asked)};
}

/// A promise in time: a writer's must not be longer than what is asked for.
Found longer(const char* policy, dds_duration_t offered, dds_duration_t asked) {
  if (offered <= asked) return {};
  return Mismatch{policy, duration_text(offered), duration_text(asked)};
}

Found reliability(const dds_qos_t& offered, const dds_qos_t& asked) {
  return weaker("reliability", reliability_of(offered), reliability_of(asked));
}

Found durability(const dds_qos_t& offered, const dds_qos_t& asked) {
  return weaker("durability", durability_of(offered), durability_of(asked));
}

Found ownership(const dds_qos_t& offered, const dds_qos_t& asked) {
  const auto of = [](const dds_qos_t& qos) {
    dds_ownership_kind_t kind = DDS_OWNERSHIP_SHARED;
    dds_qget_ownership(&qos, &kind);
    return kind;
  };
  if (of(offered) == of(asked)) return {};
  return Mismatch{"ownership", to_text(of(offered)), to_text(of(asked))};
}

Found deadline(const dds_qos_t& offered, const dds_qos_t& asked) {
  const auto of = [](const dds_qos_t& qos) {
    dds_duration_t period = DDS_INFINITY;
    dds_qget_deadline(&qos, &period);
    return period;
  };
  return longer("deadline", of(offered), of(asked));
}

Found latency_budget(const dds_qos_t& offered, const dds_qos_t& asked) {
  const auto of = [](const dds_qos_t& qos) {
    dds_duration_t duration = 0;
    dds_qget_latency_budget(&qos, &duration);
    return duration;
  };
  return longer("latency budget", of(offered), of(asked));
}

Found liveliness(const dds_qos_t& offered, const dds_qos_t& asked) {
  struct Liveliness {
    explicit Liveliness(const dds_qos_t& qos) { dds_qget_liveliness(&qos, &kind, &lease); }
    std::string text() const { return to_text(kind) + ", lease " + duration_text(lease); }
    dds_liveliness_kind_t kind = DDS_LIVELINESS_AUTOMATIC;
    dds_duration_t lease = DDS_INFINITY;
  };
  const Liveliness offer(offered);
  const Liveliness wish(asked);
  if (offer.kind >= wish.kind && offer.lease <= wish.lease) return {};
  return Mismatch{"liveliness", offer.text(), wish.text()};
}

Found destination_order(const dds_qos_t& offered, const dds_qos_t& asked) {
  const auto of = [](const dds_qos_t& qos) {
    dds_destination_order_kind_t kind = DDS_DESTINATIONORDER_BY_RECEPTION_TIMESTAMP;
    dds_qget_destination_order(&qos, &kind);
    return kind;
  };
  return weaker("destination order", of(offered), of(asked));
}

Found presentation(const dds_qos_t& offered, const dds_qos_t& asked) {
  struct Presentation {
    explicit Presentation(const dds_qos_t& qos) {
      dds_qget_presentation(&qos, &scope, &coherent, &ordered);
    }
    std::string text() const {
      return to_text(scope) + (coherent ? " coherent" : "") + (ordered ? " ordered" : "");
    }
    dds_presentation_access_scope_kind_t scope = DDS_PRESENTATION_INSTANCE;
    bool coherent = false;
    bool ordered = false;
  };
  const Presentation offer(offered);
  const Presentation wish(asked);
  const bool enough =
      offer.scope >= wish.scope && offer.coherent >= wish.coherent && offer.ordered >= wish.ordered;
  return enough ? Found{} : Mismatch{"presentation", offer.text(), wish.text()};
}

bool has_wildcard(const std::string& name) { return name.find_first_of("*?[") != name.npos; }

/// Two patterns do not match each other, says the standard.
bool same_partition(const std::string& a, const std::string& b) {
  if (has_wildcard(a) && has_wildcard(b)) return false;
  if (has_wildcard(a)) return fnmatch(a.c_str(), b.c_str(), 0) == 0;
  if (has_wildcard(b)) return fnmatch(b.c_str(), a.c_str(), 0) == 0;
  return a == b;
}

std::string partition_text(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "'" : ", '") + name + "'";
  return out;
}

Found partition(const dds_qos_t& offered, const dds_qos_t& asked) {
  const std::vector<std::string> writers = partitions_of(offered);
  const std::vector<std::string> readers = partitions_of(asked);
  for (const std::string& writer : writers) {
    for (const std::string& reader : readers) {
      if (same_partition(writer, reader)) return {};
    }
  }
  return Mismatch{"partition", partition_text(writers), partition_text(readers)};
}

std::vector<dds_data_representation_id_t> representations_of(const dds_qos_t& qos) {
  std::uint32_t count = 0;
  dds_data_representation_id_t* ids = nullptr;
  if (!dds_qget_data_representation(&qos, &count, &ids) || count == 0) {
    return {DDS_DATA_REPRESENTATION_XCDR1};  // what the standard lets an empty list mean
  }
  std::vector<dds_data_representation_id_t> out(ids, ids + count);
  dds_free(ids);
  return out;
}

std::string representation_text(const std::vector<dds_data_representation_id_t>& ids) {
  std::string out;
  for (const auto id : ids) {
    const char* name = id == DDS_DATA_REPRESENTATION_XCDR1   ? "XCDR1"
                       : id == DDS_DATA_REPRESENTATION_XCDR2 ? "XCDR2"
                                                             : "XML";
    out += (out.empty() ? "" : " or ") + std::string(name);
  }
  return out;
}

/// A writer writes in the first it lists.
Found data_representation(const dds_qos_t& offered, const dds_qos_t& asked) {
  const auto writers = representations_of(offered);
  const auto readers = representations_of(asked);
  if (std::find(readers.begin(), readers.end(), writers.front()) != readers.end()) return {};
  return Mismatch{"data representation", representation_text({writers.front()}),
                  representation_text(readers)};
}

}  // namespace

std::vector<Mismatch> mismatches(const dds_qos_t& offered, const dds_qos_t& asked) {
  std::vector<Mismatch> out;
  for (const auto rule : {reliability, durability, ownership, deadline, latency_budget, liveliness,
                          destination_order, presentation, partition, data_representation}) {
    if (Found found = rule(offered, asked)) out.push_back(std::move(*found));
  }
  return out;
}

}  // namespace scarab::bus
