#include "common/sample/idl_text.hpp"

#include <set>
#include <string_view>

namespace scarab::sample {

namespace {

const char* primitive_name(Primitive primitive) {
  switch (primitive) {
    case Primitive::kBoolean:
      return "boolean";
    case Primitive::kOctet:
      return "octet";
    case Primitive::kChar:
      return "char";
    case Primitive::kInt8:
      return "int8";
    case Primitive::kInt16:
      return "short";
    case Primitive::kInt32:
      return "long";
    case Primitive::kInt64:
      return "long long";
    case Primitive::kUint16:
      return "unsigned short";
    case Primitive::kUint32:
      return "unsigned long";
    case Primitive::kUint64:
      return "unsigned long long";
    case Primitive::kFloat:
      return "float";
    case Primitive::kDouble:
      return "double";
  }
  return "";
}

std::string bounded(const std::string& inside, std::uint32_t bound) {
  return bound == 0 ? inside : inside + ", " + std::to_string(bound);
}

struct TypeName {
  std::string operator()(Primitive primitive) const { return primitive_name(primitive); }
  std::string operator()(const StringType& string) const {
    return string.bound == 0 ? "string" : "string<" + std::to_string(string.bound) + ">";
  }
  std::string operator()(const EnumType& type) const { return type.name; }
  std::string operator()(const StructType& type) const { return type.name; }
  std::string operator()(const AliasType& type) const { return type.name; }
  std::string operator()(const SequenceType& type) const {
    return "sequence<" + bounded(idl_type_name(*type.element), type.bound) + ">";
  }
  std::string operator()(const ArrayType& type) const { return idl_type_name(*type.element); }
};

std::string dimensions(const Type& type) {
  const auto* array = std::get_if<ArrayType>(&type.kind);
  if (array == nullptr) return {};
  std::string out;
  for (const std::uint32_t size : array->dimensions) out += "[" + std::to_string(size) + "]";
  return out + dimensions(*array->element);
}

/// Splits scarab::Mode into the module part and the name.
std::pair<std::string, std::string> split(const std::string& scoped) {
  const std::size_t colons = scoped.rfind("::");
  if (colons == std::string::npos) return {"", scoped};
  return {scoped.substr(0, colons), scoped.substr(colons + 2)};
}

/// Writes declarations depth first, each in its modules.
class Writer {
 public:
  void declare(const Type& type) { std::visit(*this, type.kind); }
  std::string finish() {
    enter("");
    return out_;
  }

  void operator()(Primitive) {}
  void operator()(const StringType&) {}
  void operator()(const ArrayType& type) { declare(*type.element); }
  void operator()(const SequenceType& type) { declare(*type.element); }

  void operator()(const EnumType& type) {
    if (!begin(type.name)) return;
    out_ += "enum " + split(type.name).second + " {\n";
    std::int64_t expected = 0;
    for (const Literal& literal : type.literals) {
      out_ += "  ";
      if (literal.value != expected) out_ += "@value(" + std::to_string(literal.value) + ") ";
      out_ += literal.name + (&literal == &type.literals.back() ? "\n" : ",\n");
      expected = std::int64_t{literal.value} + 1;
    }
    out_ += "};\n";
  }

  void operator()(const StructType& type) {
    for (const Member& member : type.members) declare(*member.type);
    if (!begin(type.name)) return;
    out_ += type.extensibility == Extensibility::kFinal ? "@final " : "@appendable ";
    out_ += "struct " + split(type.name).second + " {\n";
    for (const Member& member : type.members) {
      out_ += member.key ? "  @key " : "  ";
      out_ += idl_type_name(*member.type) + " " + member.name + dimensions(*member.type) + ";\n";
    }
    out_ += "};\n";
  }

  void operator()(const AliasType& type) {
    declare(*type.target);
    if (!begin(type.name)) return;
    out_ += "typedef " + idl_type_name(*type.target) + " " + split(type.name).second +
            dimensions(*type.target) + ";\n";
  }

 private:
  /// True if the type is still to be declared; its modules are open then.
  bool begin(const std::string& name) {
    if (!declared_.insert(name).second) return false;
    enter(split(name).first);
    return true;
  }

  void enter(const std::string& module) {
    if (module == module_) return;
    for_each_part(module_, [&](std::string_view) { out_ += "};\n"; });
    for_each_part(module,
                  [&](std::string_view part) { out_ += "module " + std::string(part) + " {\n"; });
    module_ = module;
  }

  template <class F>
  static void for_each_part(std::string_view scoped, F&& f) {
    while (!scoped.empty()) {
      const std::size_t colons = scoped.find("::");
      f(scoped.substr(0, colons));
      scoped = colons == std::string_view::npos ? "" : scoped.substr(colons + 2);
    }
  }

  std::string out_;
  std::string module_;
  std::set<std::string> declared_;
};

}  // namespace

std::string idl_type_name(const Type& type) { return std::visit(TypeName{}, type.kind); }

std::string idl_text(const TypeModel& model) {
  Writer writer;
  writer.declare(*model.type());
  return writer.finish();
}

}  // namespace scarab::sample
