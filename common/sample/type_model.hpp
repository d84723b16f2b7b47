#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

/// A DDS type as a small tree, made from the type information that idlc compiles in and that
/// writers send along. What the type-less tools know of a type.
namespace scarab::sample {

enum class Primitive {
  kBoolean,
  kOctet,
  kChar,
  kInt8,
  kInt16,
  kInt32,
  kInt64,
  kUint16,
  kUint32,
  kUint64,
  kFloat,
  kDouble,
};

struct Type;
/// Types are shared: several members of a tree may have the same one.
using TypeRef = std::shared_ptr<const Type>;

struct StringType {
  std::uint32_t bound = 0;  ///< characters; 0: unbounded
};

struct Literal {
  std::string name;
  std::int32_t value = 0;
};

struct EnumType {
  std::string name;  ///< scoped, such as scarab::Mode
  std::vector<Literal> literals;

  /// The literal's name; null for a value that has none.
  const std::string* name_of(std::int32_t value) const;
};

struct Member {
  std::string name;
  TypeRef type;
  bool key = false;
};

/// How a type may grow. Decides how XCDR2 writes a struct; XCDR1 writes both alike.
enum class Extensibility { kFinal, kAppendable };

struct StructType {
  std::string name;  ///< scoped
  std::vector<Member> members;
  Extensibility extensibility = Extensibility::kFinal;
};

struct ArrayType {
  TypeRef element;
  std::vector<std::uint32_t> dimensions;  ///< outermost first

  std::size_t count() const;
};

struct SequenceType {
  TypeRef element;
  std::uint32_t bound = 0;  ///< 0: unbounded
};

struct AliasType {
  std::string name;  ///< scoped
  TypeRef target;
};

struct Type {
  std::variant<Primitive, StringType, EnumType, StructType, ArrayType, SequenceType, AliasType>
      kind;
};

/// The type behind any typedefs.
const Type& resolve(const Type& type);

/// A topic type.
class TypeModel {
 public:
  explicit TypeModel(TypeRef root);

  /// The scoped name, such as scarab::RobotState.
  const std::string& name() const;
  const StructType& root() const;
  const TypeRef& type() const { return root_; }

 private:
  TypeRef root_;
};

}  // namespace scarab::sample
