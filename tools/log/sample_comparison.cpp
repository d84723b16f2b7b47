#include "tools/log/sample_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "common/sample/field_path.hpp"
#include "common/sample/sample_json.hpp"
#include "services/logger/core/sample_header.hpp"
#include "tools/log/topic_samples.hpp"

namespace scarab::log {
namespace {

using Found = std::optional<FieldDifference>;
using Node = sample::SampleNode;

std::optional<double> number_of(const sample::Scalar& scalar) {
  if (const auto* real = std::get_if<double>(&scalar)) return *real;
  if (const auto* real = std::get_if<float>(&scalar)) return static_cast<double>(*real);
  if (const auto* whole = std::get_if<std::int64_t>(&scalar)) return static_cast<double>(*whole);
  if (const auto* whole = std::get_if<std::uint64_t>(&scalar)) return static_cast<double>(*whole);
  return std::nullopt;
}

std::string json_of(const Node& node) {
  std::string text;
  append_json(text, node);
  return text;
}

/// Walks two samples side by side up to the first difference.
class Walk {
 public:
  explicit Walk(const Lenience& lenience) : lenience_(lenience) {}

  Found compare(const Node& a, const Node& b, const std::string& path) const {
    if (is_ignored(path)) return std::nullopt;
    if (a.value.index() != b.value.index()) return FieldDifference{path, json_of(a), json_of(b)};
    if (const auto* scalar = std::get_if<sample::Scalar>(&a.value)) {
      if (are_equal(*scalar, std::get<sample::Scalar>(b.value))) return std::nullopt;
      return FieldDifference{path, json_of(a), json_of(b)};
    }
    if (const auto* list = std::get_if<Node::List>(&a.value)) {
      return compare(*list, std::get<Node::List>(b.value), path);
    }
    return compare(std::get<Node::Struct>(a.value), std::get<Node::Struct>(b.value), path);
  }

 private:
  bool is_ignored(const std::string& path) const {
    return std::any_of(lenience_.ignored.begin(), lenience_.ignored.end(),
                       [&](const std::string& field) { return sample::has_column(field, path); });
  }

  bool are_equal(const sample::Scalar& a, const sample::Scalar& b) const {
    std::string text_a;
    std::string text_b;
    append_plain(text_a, a);  // as short as reads back to the same: equal text is equal bits
    append_plain(text_b, b);
    if (text_a == text_b) return true;
    const auto in_a = number_of(a);
    const auto in_b = number_of(b);
    return lenience_.tolerance > 0 && in_a && in_b &&
           std::abs(*in_a - *in_b) <= lenience_.tolerance;
  }

  Found compare(const Node::List& a, const Node::List& b, const std::string& path) const {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
      if (auto found = compare(a[i], b[i], path + "[" + std::to_string(i) + "]")) return found;
    }
    if (a.size() == b.size() || is_ignored(path + ".length")) return std::nullopt;
    return FieldDifference{path + ".length", std::to_string(a.size()), std::to_string(b.size())};
  }

  Found compare(const Node::Struct& a, const Node::Struct& b, const std::string& path) const {
    const std::string front = path.empty() ? "" : path + ".";
    const auto member_of = [](const Node::Struct& from, std::string_view name) {
      const auto at = std::find_if(from.begin(), from.end(),
                                   [&](const auto& member) { return member.first == name; });
      return at == from.end() ? nullptr : &at->second;
    };
    for (const auto& [name, in_a] : a) {
      const std::string field = front + std::string(name);
      const Node* in_b = member_of(b, name);
      if (in_b == nullptr && !is_ignored(field)) return FieldDifference{field, json_of(in_a), ""};
      if (in_b == nullptr) continue;
      if (auto found = compare(in_a, *in_b, field)) return found;
    }
    for (const auto& [name, in_b] : b) {
      const std::string field = front + std::string(name);
      if (member_of(a, name) == nullptr && !is_ignored(field)) {
        return FieldDifference{field, "", json_of(in_b)};
      }
    }
    return std::nullopt;
  }

  const Lenience& lenience_;
};

FieldDifference differing_byte(mcap::ByteView a, mcap::ByteView b, bool have_header) {
  const std::size_t shorter = std::min(a.size(), b.size());
  const auto is_stamp = [&](std::size_t at) {
    return have_header && at >= logger::kStampBegin && at < logger::kStampEnd;
  };
  std::size_t at = 0;
  while (at < shorter && (a[at] == b[at] || is_stamp(at))) ++at;
  const auto value = [at](mcap::ByteView bytes) {
    return at < bytes.size() ? std::to_string(bytes[at]) : std::string();
  };
  return {"byte " + std::to_string(at), value(a), value(b)};
}

sample::ByteView view(mcap::ByteView bytes) {
  return {reinterpret_cast<const std::byte*>(bytes.data()), bytes.size()};
}

}  // namespace

std::string to_string(const FieldDifference& difference) {
  const auto value = [](const std::string& text) { return text.empty() ? "nothing" : text; };
  return difference.field + ": " + value(difference.a) + " and " + value(difference.b);
}

SampleComparison::SampleComparison(const LogChannel* a, const LogChannel* b, Lenience lenience)
    : lenience_(std::move(lenience)) {
  if (a == nullptr) a = b;
  if (b == nullptr) b = a;
  if (a == nullptr) return;
  type_a_ = a->type ? a->type : b->type;
  type_b_ = b->type ? b->type : a->type;
  have_header_ = a->has_header && b->has_header;
  if (have_header_) lenience_.ignored.emplace_back("header.stamp_ns");
}

Found SampleComparison::difference(mcap::ByteView a, mcap::ByteView b) const {
  if (equal_bytes(a, b, have_header_)) return std::nullopt;
  if (!type_a_) return differing_byte(a, b, have_header_);
  auto found = Walk(lenience_).compare(sample::sample_tree(*type_a_, view(a)),
                                       sample::sample_tree(*type_b_, view(b)), "");
  if (found) return found;
  // Another byte order or representation says the same in other bytes.
  constexpr std::size_t kRepresentation = 2;
  const bool alike = std::equal(a.begin(), a.begin() + kRepresentation, b.begin());
  const bool strict = !lenience_.values_only && lenience_.tolerance == 0 &&
                      lenience_.ignored.size() == (have_header_ ? 1U : 0U);
  if (alike && strict) return differing_byte(a, b, have_header_);
  return std::nullopt;
}

}  // namespace scarab::log
