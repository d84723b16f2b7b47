#include "common/runtime/end_words.hpp"

namespace scarab::runtime {
namespace {

std::string beginning(std::uint32_t trial, bool success) {
  return "trial " + std::to_string(trial) + " ended: " + (success ? "success: " : "failure: ");
}

}  // namespace

std::string end_words(std::uint32_t trial, const TrialEnd& end) {
  return beginning(trial, end.success) + end.reason;
}

std::optional<std::string> reason_in(const std::string& message, std::uint32_t trial) {
  for (const bool success : {true, false}) {
    const std::string before = beginning(trial, success);
    const std::size_t found = message.find(before);
    if (found != std::string::npos) return message.substr(found + before.size());
  }
  return std::nullopt;
}

}  // namespace scarab::runtime
