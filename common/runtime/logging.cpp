#include "common/runtime/logging.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace scarab::runtime {

void set_up_logging(const std::string& service, unsigned instance, const std::string& level) {
  auto logger = std::make_shared<spdlog::logger>(service + "/" + std::to_string(instance),
                                                 std::make_shared<spdlog::sinks::stderr_sink_mt>());
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %n: %v");
  logger->set_level(spdlog::level::from_str(level));
  logger->flush_on(spdlog::level::info);
  spdlog::set_default_logger(std::move(logger));
}

}  // namespace scarab::runtime
