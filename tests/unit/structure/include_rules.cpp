#include "tests/unit/structure/include_rules.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace scarab::structure {
namespace {

using Names = std::set<std::string>;

bool starts_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool starts_with_any(const std::string& text, const Names& starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](const std::string& start) { return starts_with(text, start); });
}

/// One line for each include for which `is_allowed(include)` is false.
template <class Predicate>
Violations refuse_unless(const SourceFile& file, const std::string& rule, Predicate is_allowed) {
  Violations violations;
  for (const Include& include : file.includes) {
    if (is_allowed(include)) continue;
    violations.push_back(file.path + ":" + std::to_string(include.line) + ": includes " +
                         include.target + ", but " + rule);
  }
  return violations;
}

const std::string kBridge = "services/robot_bridge/";
const std::string kDrivers = kBridge + "drivers/";

/// The driver whose folder a path is in, such as amosii; empty outside of drivers.
std::string driver_of(const std::string& path) {
  const std::vector<std::string> parts = parts_of(path);
  return starts_with(path, kDrivers) && parts.size() > 4 ? parts[3] : "";
}

/// services/plant/core/ for any file below it, and the same for the protocol of a robot's driver;
/// empty outside of both.
std::string core_of(const SourceFile& file) {
  const std::string protocol = kDrivers + driver_of(file.path) + "/protocol/";
  if (starts_with(file.path, protocol)) return protocol;
  const std::string prefix = file.part(0) + "/" + file.part(1) + "/core/";
  return (file.is_in("services") || file.is_in("tools")) && starts_with(file.path, prefix) ? prefix
                                                                                           : "";
}

/// Standard headers are those without a dot or a slash in their names.
bool is_pure_standard_header(const std::string& target) {
  static const Names impure = {
      "chrono",  "ctime",      "thread",     "mutex",     "condition_variable", "shared_mutex",
      "future",  "atomic",     "stop_token", "semaphore", "iostream",           "fstream",
      "csignal", "filesystem", "random",     "syncstream"};
  return target.find_first_of("./") == std::string::npos && impure.count(target) == 0;
}

bool is_simbody(const std::string& target) {
  return starts_with_any(target, {"Simbody.h", "SimTK", "simbody/", "simmath/"});
}

const Names kPureCommon = {"common/robot/", "common/safety/", "common/random/", "common/sample/"};

/// Which folders of common/ each folder of common/ may include, besides itself.
const std::map<std::string, Names>& common_layers() {
  static const std::map<std::string, Names> layers = {
      {"random", {}},        {"robot", {}},
      {"safety", {"robot"}}, {"config", {"robot"}},
      {"sample", {}},        {"bus", {"sample"}},
      {"mcap", {}},          {"runtime", {"bus", "config", "random", "robot", "safety", "sample"}},
  };
  return layers;
}

bool common_may_include(const std::string& folder, const std::string& target) {
  const std::vector<std::string> to = parts_of(target);
  const auto layer = common_layers().find(folder);
  if (layer == common_layers().end() || to.size() < 3) return false;
  return to[1] == folder || layer->second.count(to[1]) != 0;
}

bool tool_may_include(const SourceFile& file, const std::vector<std::string>& to) {
  // How cores are put together in one process: there must not be a second way to run a trial.
  static const std::vector<std::string> composition = {"tools", "sim", "composition.hpp"};
  if (to[0] == "tools") return to[1] == file.part(1) || to == composition;
  const std::string& room = to[2];
  // What speaks to the bridge must know what the bridge was told and how its drivers speak.
  if (to[1] == "robot_bridge" && room == "calibration_file.hpp") return true;
  if (to[1] == "robot_bridge" && room == "drivers" && to.size() > 4) {
    return to[4] == "config.hpp" || to[4] == "protocol";
  }
  // The loop of a worker is one, whatever runs its trials.
  const bool worker = to[1] == "experiment" && room == "worker.hpp";
  return room == "core" || room == "adapter.hpp" || room == "config.hpp" || worker;
}

}  // namespace

bool is_pure(const SourceFile& file) {
  return !core_of(file).empty() || starts_with_any(file.path, kPureCommon);
}

Violations check_pure_includes(const SourceFile& file) {
  if (!is_pure(file)) return {};
  const std::string core = core_of(file);
  const bool is_plant = core == "services/plant/core/";
  return refuse_unless(
      file,
      "pure code takes the standard library (no clocks, threads, files), Eigen "
      "and pure folders only",
      [&](const Include& include) {
        const std::string& target = include.target;
        if (!include.angled) {
          return starts_with_any(target, kPureCommon) ||
                 (!core.empty() && starts_with(target, core)) ||
                 (starts_with(core, kDrivers) && starts_with(target, kBridge + "core/"));
        }
        // fmt/format.h is C++20's <format>: text from values, no stream, no state.
        return is_pure_standard_header(target) || starts_with(target, "Eigen/") ||
               target == "fmt/format.h" || (is_plant && is_simbody(target));
      });
}

Violations check_dds_includes(const SourceFile& file) {
  // Samples as raw CDR, type objects, and the log sink: what the public API does not offer.
  static const Names internals = {"common/bus/raw_cdr.cpp", "common/bus/type_object_walker.cpp",
                                  "common/bus/made_descriptor.cpp", "common/bus/cyclone_log.cpp"};
  return refuse_unless(
      file, "<dds/...> belongs to common/bus, its internals to four files there",
      [&](const Include& include) {
        if (!starts_with(include.target, "dds/")) return true;
        const bool is_internal = starts_with_any(include.target, {"dds/ddsi", "dds/ddsrt"});
        return is_internal ? internals.count(file.path) != 0 : file.is_in("common/bus");
      });
}

Violations check_library_homes(const SourceFile& file) {
  return refuse_unless(file, "that library has one home", [&](const Include& include) {
    const std::string& target = include.target;
    const bool is_header = file.path.compare(file.path.size() - 3, 3, "cpp") != 0;
    if (starts_with(target, "yaml-cpp/")) return file.is_in("common/config") && !is_header;
    if (starts_with(target, "zstd") || starts_with(target, "lz4")) return file.is_in("common/mcap");
    if (is_simbody(target)) return file.is_in("services/plant/core");
    return true;
  });
}

Violations check_layers(const SourceFile& file) {
  return refuse_unless(
      file, "common is below services, services below tools, and neighbours do not know each other",
      [&](const Include& include) {
        const std::vector<std::string> to = parts_of(include.target);
        if (include.angled || to.size() < 3) return true;
        if (to[0] == "common") {
          return !file.is_in("common") || common_may_include(file.part(1), include.target);
        }
        if (to[0] != "services" && to[0] != "tools") return to[0] != "tests";
        if (file.is_in("common")) return false;
        if (file.is_in("tools")) return tool_may_include(file, to);
        return to[0] == "services" && to[1] == file.part(1);
      });
}

Violations check_driver_includes(const SourceFile& file) {
  if (!file.is_in(kBridge)) return {};
  const std::string own = driver_of(file.path);
  return refuse_unless(
      file,
      "a driver knows the bridge's core, the serial line and itself; the bridge knows of a driver "
      "its config.hpp",
      [&](const Include& include) {
        const std::string& target = include.target;
        if (include.angled) return true;
        const std::string other = driver_of(target);
        if (own.empty()) return other.empty() || target == kDrivers + other + "/config.hpp";
        if (starts_with(target, "common/")) {
          return starts_with_any(target, {"common/config/"}) ||
                 starts_with_any(target, kPureCommon);
        }
        return starts_with(target, kBridge + "core/") || other == own || other == "serial";
      });
}

Violations check_main_includes(const SourceFile& file) {
  if (file.file_name() != "main.cpp") return {};
  return refuse_unless(file, "main.cpp only parses its command line and starts its service",
                       [&](const Include& include) {
                         const std::vector<std::string> to = parts_of(include.target);
                         if (starts_with(include.target, "common/bus/")) return false;
                         return to.size() < 3 || to[0] == "common" ||
                                (to[2] != "core" && to[2] != "adapter.hpp");
                       });
}

}  // namespace scarab::structure
