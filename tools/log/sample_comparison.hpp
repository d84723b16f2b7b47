#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/log/log.hpp"

namespace scarab::log {

/// What does not count as a difference.
struct Lenience {
  std::vector<std::string> ignored;  ///< fields, or the beginnings of several (bus::has_column)
  double tolerance = 0;              ///< numbers may differ by this much
  bool values_only = false;          ///< what stands between the fields does not count
};

/// The first field in which two samples differ.
struct FieldDifference {
  std::string field;  ///< as bus::FieldPath; `byte 17` where the type is not known
  std::string a;      ///< the values, as JSON; empty: there is none
  std::string b;
};

/// `inputs[2]: 0 and 0.25`.
std::string to_string(const FieldDifference& difference);

/// Compares samples of a topic in two logs: byte by byte, the header's wall-clock stamp aside, and
/// where the bytes differ field by field.
class SampleComparison {
 public:
  /// The channels of the topic in the two logs, each with its type if it is known; null: as the
  /// other.
  SampleComparison(const LogChannel* a, const LogChannel* b, Lenience lenience);

  /// Nothing: the two are equal. What stands between the fields, and in no field, counts only where
  /// nothing is ignored or tolerated. Throws bus::Error for bytes that are no sample.
  std::optional<FieldDifference> difference(mcap::ByteView a, mcap::ByteView b) const;

 private:
  std::optional<sample::TypeModel> type_a_;
  std::optional<sample::TypeModel> type_b_;
  bool have_header_ = false;
  Lenience lenience_;
};

}  // namespace scarab::log
