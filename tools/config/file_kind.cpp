#include "tools/config/file_kind.hpp"

#include <algorithm>

#include "common/config/config.hpp"
#include "common/config/robot_schema.hpp"
#include "services/logger/config.hpp"
#include "services/plant/config.hpp"
#include "services/premotor/config.hpp"
#include "services/robot_bridge/calibration_file.hpp"
#include "services/robot_bridge/config.hpp"
#include "services/supervisor/config.hpp"

namespace scarab::config_tool {
namespace {

using Path = std::filesystem::path;

const FileKind* find(std::string_view name) {
  const auto& kinds = file_kinds();
  const auto* const found = std::find_if(kinds.begin(), kinds.end(),
                                         [&](const FileKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : found;
}

}  // namespace

const std::array<FileKind, kKindCount>& file_kinds() {
  static const std::array<FileKind, kKindCount> kinds = {{
      {"calibration",
       [](const Path& file) { return bridge::dump_calibration(bridge::load_calibration(file)); },
       bridge::calibration_schema},
      {"logger", [](const Path& file) { return logger::dump_config(logger::load_config(file)); },
       logger::config_schema},
      {"plant", [](const Path& file) { return plant::dump_config(plant::load_config(file)); },
       plant::config_schema},
      {"premotor",
       [](const Path& file) { return premotor::dump_config(premotor::load_config(file)); },
       premotor::config_schema},
      // Not by way of robot::RobotModel, in which servos have lost their names.
      {"robot",
       [](const Path& file) { return config::dump(config::load<config::RobotSchema>(file)); },
       [] { return config::schema<config::RobotSchema>("Scarab: config/robot"); }},
      {"robot_bridge",
       [](const Path& file) { return bridge::dump_config(bridge::load_config(file)); },
       bridge::config_schema},
      {"supervisor",
       [](const Path& file) { return supervisor::dump_config(supervisor::load_config(file)); },
       supervisor::config_schema},
  }};
  return kinds;
}

std::string kind_names() {
  std::string names;
  for (const FileKind& kind : file_kinds()) {
    names += (names.empty() ? "" : ", ") + std::string(kind.name);
  }
  return names;
}

const FileKind& kind_named(std::string_view name) {
  if (const FileKind* kind = find(name)) return *kind;
  throw WrongKind("no kind '" + std::string(name) + "' of configuration; there are " +
                  kind_names());
}

const FileKind& kind_of(const Path& file) {
  const Path folder = std::filesystem::absolute(file).lexically_normal().parent_path().filename();
  if (const FileKind* kind = find(folder.string())) return *kind;
  throw WrongKind(file.string() +
                  ": its folder says no kind of configuration; name one with "
                  "--kind (" +
                  kind_names() + ")");
}

}  // namespace scarab::config_tool
