#pragma once

#include <filesystem>
#include <string>

#include "services/plant/core/plant_config.hpp"

namespace scarab::plant {

/// Reads config/plant/*.yaml. Throws config::Error (`file:line:col: key: reason`).
PlantConfig load_config(const std::filesystem::path& path);

/// The same from text; errors name it `file`.
PlantConfig load_config_text(const std::string& file, const std::string& text);

/// YAML that load_config reads back to an equal value.
std::string dump_config(const PlantConfig& config);

/// JSON Schema of the files that load_config reads (config/schema/plant.json).
std::string config_schema();

}  // namespace scarab::plant
