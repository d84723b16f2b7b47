#include "common/sample/cdr_builder.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>

#include "common/sample/cdr_output.hpp"
#include "common/sample/cdr_rules.hpp"
#include "common/sample/field_path.hpp"
#include "common/sample/written_number.hpp"

namespace scarab::sample {

namespace {

using Kind = WrittenValue::Kind;

const WrittenValue kNothing{};

/// A time as ROS 2 writes it.
bool is_time(const StructType& type) {
  return type.members.size() == 2 && type.members[0].name == "sec" &&
         type.members[1].name == "nanosec";
}

WrittenValue number(std::int64_t value) {
  return {Kind::kText, std::to_string(value), false, {}, {}};
}

WrittenValue time_of(std::int64_t time_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  return {Kind::kMap,
          "",
          false,
          {"sec", "nanosec"},
          {number(time_ns / kSecond), number(time_ns % kSecond)}};
}

bool is_now(const WrittenValue& value) { return value.kind == Kind::kText && value.text == "now"; }

bool holds_ns(Primitive primitive) {
  return primitive == Primitive::kInt64 || primitive == Primitive::kUint64;
}

class Builder {
 public:
  Builder(CdrOutput::Encoding encoding, std::int64_t now_ns) : out_(encoding), now_ns_(now_ns) {}

  Bytes finish() { return out_.finish(); }

  void build(const Type& type, const WrittenValue& value, const std::string& path) {
    if (const auto* structure = std::get_if<StructType>(&type.kind)) {
      build_struct(*structure, value, path);
    } else if (const auto* alias = std::get_if<AliasType>(&type.kind)) {
      build(*alias->target, value, path);
    } else if (const auto* array = std::get_if<ArrayType>(&type.kind)) {
      const CdrOutput::Delimited part(out_, out_.is_xcdr2() && is_delimited(*array));
      build_array(*array, 0, value, path);
    } else if (const auto* sequence = std::get_if<SequenceType>(&type.kind)) {
      build_sequence(*sequence, value, path);
    } else {
      build_scalar(type, value, path);
    }
  }

 private:
  static Error wrong(const std::string& path, const std::string& reason) {
    return Error(path.empty() ? reason : path + ": " + reason);
  }

  void build_struct(const StructType& type, const WrittenValue& value, const std::string& path) {
    if (is_now(value) && is_time(type)) {
      return build_struct(type, time_of(now_ns_), path);
    }
    if (value.kind != Kind::kMap && value.kind != Kind::kNothing) {
      throw wrong(path, "a map of the members of " + type.name + " expected");
    }
    check_names(type, value, path);
    const CdrOutput::Delimited part(out_, out_.is_xcdr2() && is_delimited(type));
    for (const Member& member : type.members) {
      const auto found = std::find(value.keys.begin(), value.keys.end(), member.name);
      const auto index = static_cast<std::size_t>(found - value.keys.begin());
      build(*member.type, found == value.keys.end() ? kNothing : value.items[index],
            path.empty() ? member.name : path + "." + member.name);
    }
  }

  static void check_names(const StructType& type, const WrittenValue& value,
                          const std::string& path) {
    std::set<std::string> given;
    for (const std::string& name : value.keys) {
      const bool known = std::any_of(type.members.begin(), type.members.end(),
                                     [&](const Member& member) { return member.name == name; });
      if (!known && path.empty()) throw NoSuchMember(name, type);
      if (!known) throw NoSuchMember(path, NoSuchMember(name, type));
      if (!given.insert(name).second) throw wrong(path, name + " is given twice");
    }
  }

  void build_array(const ArrayType& type, std::size_t depth, const WrittenValue& value,
                   const std::string& path) {
    if (depth == type.dimensions.size()) {
      // An array of arrays has one length before it, see is_delimited().
      const Type& element = resolve(*type.element);
      if (const auto* inner = std::get_if<ArrayType>(&element.kind)) {
        return build_array(*inner, 0, value, path);
      }
      return build(element, value, path);
    }
    const std::size_t size = type.dimensions[depth];
    expect_list(value, path);
    if (value.kind == Kind::kList && value.items.size() != size) {
      throw wrong(path, std::to_string(value.items.size()) + " elements, but it has " +
                            std::to_string(size));
    }
    for (std::size_t i = 0; i < size; ++i) {
      build_array(type, depth + 1, value.kind == Kind::kList ? value.items[i] : kNothing,
                  path + "[" + std::to_string(i) + "]");
    }
  }

  void build_sequence(const SequenceType& type, const WrittenValue& value,
                      const std::string& path) {
    expect_list(value, path);
    const std::size_t size = value.items.size();
    if (type.bound != 0 && size > type.bound) {
      throw wrong(path, std::to_string(size) + " elements, at most " + std::to_string(type.bound));
    }
    const CdrOutput::Delimited part(out_, out_.is_xcdr2() && is_delimited(type));
    out_.write(static_cast<std::uint32_t>(size));
    for (std::size_t i = 0; i < size; ++i) {
      build(*type.element, value.items[i], path + "[" + std::to_string(i) + "]");
    }
  }

  static void expect_list(const WrittenValue& value, const std::string& path) {
    if (value.kind != Kind::kList && value.kind != Kind::kNothing) {
      throw wrong(path, "a list expected");
    }
  }

  void build_scalar(const Type& type, const WrittenValue& value, const std::string& path) {
    try {
      if (const auto* text = std::get_if<StringType>(&type.kind)) {
        build_text(*text, value);
      } else if (const auto* enumeration = std::get_if<EnumType>(&type.kind)) {
        out_.write(enum_number(*enumeration, value));
      } else {
        const auto primitive = std::get<Primitive>(type.kind);
        const bool now = is_now(value) && holds_ns(primitive);
        write_primitive(primitive, now ? number(now_ns_) : value, out_);
      }
    } catch (const Error& error) {
      throw wrong(path, error.what());
    }
  }

  void build_text(const StringType& type, const WrittenValue& value) {
    if (value.kind == Kind::kList || value.kind == Kind::kMap) throw Error("text expected");
    if (value.text.find('\0') != std::string::npos) throw Error("text with a zero in it");
    if (type.bound != 0 && value.text.size() > type.bound) {
      throw Error("text of " + std::to_string(value.text.size()) + " bytes, at most " +
                  std::to_string(type.bound));
    }
    out_.write_text(value.text);
  }

  CdrOutput out_;
  std::int64_t now_ns_;
};

CdrOutput::Encoding encoding_of(const TypeModel& model) {
  if (!needs_xcdr2(*model.type())) return CdrOutput::Encoding::kXcdr1;
  return is_delimited(model.root()) ? CdrOutput::Encoding::kDelimitedXcdr2
                                    : CdrOutput::Encoding::kXcdr2;
}

}  // namespace

Bytes build_cdr(const TypeModel& model, const WrittenValue& value, std::int64_t now_ns) {
  Builder builder(encoding_of(model), now_ns);
  builder.build(*model.type(), value, "");
  return builder.finish();
}

}  // namespace scarab::sample
