#include "tools/log/ros_message.hpp"

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <utility>

#include "common/bus/error.hpp"

namespace scarab::log {
namespace {

/// `sensor_msgs/JointState` of `sensor_msgs/msg/JointState`.
std::string short_name(std::string name) {
  const std::size_t at = name.find("/msg/");
  return at == std::string::npos ? name : name.replace(at, 5, "/");
}

const std::map<std::string, sample::Primitive>& primitives() {
  using sample::Primitive;
  static const std::map<std::string, Primitive> kPrimitives = {
      {"bool", Primitive::kBoolean},  {"byte", Primitive::kOctet},
      {"char", Primitive::kOctet},    {"uint8", Primitive::kOctet},
      {"int8", Primitive::kInt8},     {"int16", Primitive::kInt16},
      {"uint16", Primitive::kUint16}, {"int32", Primitive::kInt32},
      {"uint32", Primitive::kUint32}, {"int64", Primitive::kInt64},
      {"uint64", Primitive::kUint64}, {"float32", Primitive::kFloat},
      {"float64", Primitive::kDouble}};
  return kPrimitives;
}

struct Line {
  std::size_t number = 0;
  std::string type;
  std::string name;
};
using Definitions = std::map<std::string, std::vector<Line>>;

/// Type and name of a field; nothing for constants, comments and empty lines.
std::optional<Line> field_of(const std::string& line, std::size_t number) {
  std::istringstream words(line.substr(0, line.find('#')));
  Line field;
  field.number = number;
  if (!(words >> field.type)) return std::nullopt;
  std::string next;
  if (!(words >> field.name)) throw bus::Error("line " + std::to_string(number) + ": no name");
  words >> next;
  const bool is_constant = field.name.find('=') != std::string::npos || next.rfind('=', 0) == 0;
  return is_constant ? std::nullopt : std::optional<Line>(field);
}

Definitions split(const std::string& text, const std::string& type_name) {
  Definitions definitions;
  std::string name = short_name(type_name);
  definitions[name];
  std::istringstream lines(text);
  std::string line;
  for (std::size_t number = 1; std::getline(lines, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.rfind("====", 0) == 0) continue;
    if (line.rfind("MSG:", 0) == 0) {
      std::istringstream(line.substr(4)) >> name;
      name = short_name(name);
      definitions[name];
    } else if (const auto field = field_of(line, number)) {
      definitions[name].push_back(*field);
    }
  }
  return definitions;
}

class Builder {
 public:
  explicit Builder(Definitions definitions) : definitions_(std::move(definitions)) {}

  sample::TypeRef message(const std::string& name, std::size_t line) {
    const auto made = made_.find(name);
    if (made != made_.end()) return made->second;
    const auto definition = definitions_.find(name);
    if (definition == definitions_.end() || !open_.insert(name).second) {
      throw bus::Error("line " + std::to_string(line) + ": no definition of " + name);
    }
    sample::StructType structure;
    structure.name = name;
    for (const Line& field : definition->second) {
      structure.members.push_back({field.name, type(field, name.substr(0, name.find('/'))), false});
    }
    if (structure.members.empty()) {  // what rosidl makes of it, for IDL has no empty struct
      structure.members.push_back(
          {"structure_needs_at_least_one_member", make(sample::Primitive::kOctet), false});
    }
    open_.erase(name);
    return made_[name] = make(std::move(structure));
  }

 private:
  template <class Kind>
  static sample::TypeRef make(Kind kind) {
    return std::make_shared<const sample::Type>(sample::Type{std::move(kind)});
  }

  static std::uint32_t number(const std::string& text, const Line& line) {
    if (text.empty() || text.find_first_not_of("0123456789") != std::string::npos) {
      throw bus::Error("line " + std::to_string(line.number) + ": '" + text + "' is no number");
    }
    return static_cast<std::uint32_t>(std::stoul(text));
  }

  /// `float64[]`, `Point[3]`, `string<=10[<=5]`.
  sample::TypeRef type(const Line& line, const std::string& package) {
    const std::size_t bracket = line.type.find('[');
    const sample::TypeRef element = single(line.type.substr(0, bracket), line, package);
    if (bracket == std::string::npos) return element;
    if (line.type.back() != ']') {
      throw bus::Error("line " + std::to_string(line.number) + ": [ without ]");
    }
    const std::string bound = line.type.substr(bracket + 1, line.type.size() - bracket - 2);
    if (bound.empty()) return make(sample::SequenceType{element, 0});
    if (bound.rfind("<=", 0) == 0) {
      return make(sample::SequenceType{element, number(bound.substr(2), line)});
    }
    return make(sample::ArrayType{element, {number(bound, line)}});
  }

  sample::TypeRef single(const std::string& name, const Line& line, const std::string& package) {
    const auto primitive = primitives().find(name);
    if (primitive != primitives().end()) return make(primitive->second);
    if (name == "string") return make(sample::StringType{});
    if (name.rfind("string<=", 0) == 0)
      return make(sample::StringType{number(name.substr(8), line)});
    if (name.rfind("wstring", 0) == 0) {
      throw bus::Error("line " + std::to_string(line.number) + ": wide strings are not read");
    }
    const std::string known = short_name(name);
    if (known.find('/') != std::string::npos) return message(known, line.number);
    return message(known == "Header" && definitions_.count(package + "/Header") == 0
                       ? "std_msgs/Header"
                       : package + "/" + known,
                   line.number);
  }

  Definitions definitions_;
  std::map<std::string, sample::TypeRef> made_;
  std::set<std::string> open_;  // being made: a type that holds itself is none
};

}  // namespace

sample::TypeModel parse_ros_message(const std::string& text, const std::string& type_name) {
  return sample::TypeModel(Builder(split(text, type_name)).message(short_name(type_name), 1));
}

}  // namespace scarab::log
