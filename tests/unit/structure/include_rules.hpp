#pragma once

#include <string>
#include <vector>

#include "tests/unit/structure/source_file.hpp"

/// What may include what (docs: architecture). Each rule returns one line for each violation, empty
/// if the file keeps it.
namespace scarab::structure {

using Violations = std::vector<std::string>;

/// Cores, the protocols of a robot's drivers and the pure folders of common/: only they themselves,
/// the standard library and Eigen; the plant's core also Simbody.
[[nodiscard]] bool is_pure(const SourceFile& file);

/// Pure files include the standard library without its clocks, threads and streams to the outside,
/// Eigen, pure folders of common/ and their own core; a driver's protocol also the bridge's core;
/// nothing else.
[[nodiscard]] Violations check_pure_includes(const SourceFile& file);

/// <dds/...> only in common/bus; DDS internals only in the .cpp files named in the rule.
[[nodiscard]] Violations check_dds_includes(const SourceFile& file);

/// Libraries with one home: yaml-cpp in common/config, Simbody in the plant's core, zstd in
/// common/mcap.
[[nodiscard]] Violations check_library_homes(const SourceFile& file);

/// Layers: common/ below services/ below tools/; services do not know each other, nor tools each
/// other; tools know of a service its core, adapter and configuration, and the protocols of a
/// robot's drivers; folders of common/ as the table in the rule says.
[[nodiscard]] Violations check_layers(const SourceFile& file);

/// Drivers of the robot bridge know its core and the serial line, not each other, the bus or the
/// rest of the bridge; that rest knows of a driver its config.hpp.
[[nodiscard]] Violations check_driver_includes(const SourceFile& file);

/// main.cpp knows its service and configuration, not its core, its adapter or the bus.
[[nodiscard]] Violations check_main_includes(const SourceFile& file);

}  // namespace scarab::structure
