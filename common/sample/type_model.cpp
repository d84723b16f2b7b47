#include "common/sample/type_model.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

#include "common/sample/error.hpp"

namespace scarab::sample {

const std::string* EnumType::name_of(std::int32_t value) const {
  const auto found = std::find_if(literals.begin(), literals.end(),
                                  [&](const Literal& literal) { return literal.value == value; });
  return found == literals.end() ? nullptr : &found->name;
}

std::size_t ArrayType::count() const {
  return std::accumulate(dimensions.begin(), dimensions.end(), std::size_t{1},
                         std::multiplies<std::size_t>());
}

const Type& resolve(const Type& type) {
  const Type* at = &type;
  while (const auto* alias = std::get_if<AliasType>(&at->kind)) at = alias->target.get();
  return *at;
}

TypeModel::TypeModel(TypeRef root) : root_(std::move(root)) {
  if (!std::holds_alternative<StructType>(root_->kind))
    throw Error("a topic type must be a struct");
}

const std::string& TypeModel::name() const { return root().name; }

const StructType& TypeModel::root() const { return std::get<StructType>(root_->kind); }

}  // namespace scarab::sample
