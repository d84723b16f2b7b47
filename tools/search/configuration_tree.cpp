#include "tools/search/configuration_tree.hpp"

#include <algorithm>
#include <stdexcept>

#include "common/config/emit.hpp"
#include "common/config/extends.hpp"
#include "common/config/robot_file.hpp"
#include "common/config/scalar.hpp"
#include "services/plant/config.hpp"
#include "services/premotor/config.hpp"
#include "services/supervisor/config.hpp"
#include "tools/search/value_path.hpp"

namespace scarab::search {
namespace {

std::size_t index_of(std::string_view kind) {
  const auto* const found = std::find(kKinds.begin(), kKinds.end(), kind);
  if (found == kKinds.end()) throw std::invalid_argument("no kind " + std::string(kind));
  return static_cast<std::size_t>(found - kKinds.begin());
}

}  // namespace

SplitPath split_path(std::string_view path) {
  const std::size_t dot = path.find('.');
  const std::string_view kind = path.substr(0, dot);
  const bool known = std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
  if (!known || dot == std::string_view::npos) return {};
  return {kind, path.substr(dot + 1)};
}

ConfigurationTree::ConfigurationTree(const BaseNames& names, const std::filesystem::path& folder) {
  const std::array<const std::string*, kKinds.size()> files = {&names.robot, &names.plant,
                                                               &names.premotor, &names.supervisor};
  for (std::size_t i = 0; i < files.size(); ++i) {
    documents_[i] = config::read_extended((folder / *files[i]).lexically_normal());
  }
}

bool ConfigurationTree::has_number(std::string_view path) const {
  const auto [kind, rest] = split_path(path);
  if (kind.empty()) return false;
  const config::Value* value = find_value(document(kind).root, rest);
  return value != nullptr && value->kind == config::Value::Kind::kScalar && value->plain &&
         config::parse_number(value->text).value.has_value();
}

double ConfigurationTree::number(std::string_view path) const {
  if (!has_number(path)) throw std::invalid_argument("no number at " + std::string(path));
  const auto [kind, rest] = split_path(path);
  return number_at(document(kind).root, rest);
}

void ConfigurationTree::set_number(std::string_view path, double value) {
  if (!has_number(path)) throw std::invalid_argument("no number at " + std::string(path));
  const auto [kind, rest] = split_path(path);
  find_value(documents_[index_of(kind)].root, rest)->text = config::format_number(value);
}

const config::Document& ConfigurationTree::document(std::string_view kind) const {
  return documents_[index_of(kind)];
}

std::string ConfigurationTree::text(std::string_view kind) const {
  return config::emit(document(kind).root);
}

std::string ConfigurationTree::name(std::string_view kind) const {
  return document(kind).files[0] + " (as changed)";
}

sim::Configuration ConfigurationTree::build() const {
  sim::Configuration result;
  result.robot = config::load_robot_text(name("robot"), text("robot"));
  result.plant = plant::load_config_text(name("plant"), text("plant"));
  result.premotor = premotor::load_config_text(name("premotor"), text("premotor"));
  result.supervisor = supervisor::load_config_text(name("supervisor"), text("supervisor"));
  return result;
}

}  // namespace scarab::search
