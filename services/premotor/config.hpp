#pragma once

#include <filesystem>
#include <string>

#include "services/premotor/core/premotor_config.hpp"

namespace scarab::premotor {

/// Reads config/premotor/*.yaml. Throws config::Error (`file:line:col: key: reason`).
PremotorConfig load_config(const std::filesystem::path& path);

/// The same from text; errors name it `file`.
PremotorConfig load_config_text(const std::string& file, const std::string& text);

/// YAML that load_config reads back to an equal value.
std::string dump_config(const PremotorConfig& config);

/// JSON Schema of the files that load_config reads (config/schema/premotor.json).
std::string config_schema();

}  // namespace scarab::premotor
