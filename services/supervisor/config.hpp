#pragma once

#include <filesystem>
#include <string>

#include "services/supervisor/core/supervisor_config.hpp"

namespace scarab::supervisor {

/// Reads config/supervisor/*.yaml. Throws config::Error (`file:line:col: key: reason`).
SupervisorConfig load_config(const std::filesystem::path& path);

/// The same from text; errors name it `file`.
SupervisorConfig load_config_text(const std::string& file, const std::string& text);

/// YAML that load_config reads back to an equal value.
std::string dump_config(const SupervisorConfig& config);

/// JSON Schema of the files that load_config reads (config/schema/supervisor.json).
std::string config_schema();

}  // namespace scarab::supervisor
