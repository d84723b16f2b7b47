#include "tools/topic/failure.hpp"

#include "common/config/suggestion.hpp"
#include "common/runtime/program.hpp"
#include "common/sample/field_path.hpp"

namespace scarab::topic {

std::string did_you_mean(const std::string& word, const std::vector<std::string>& names) {
  const auto near = config::closest(word, {names.begin(), names.end()});
  return near ? "; did you mean " + std::string(*near) + "?" : "";
}

void refuse_bad_usage(const std::string& context, const std::function<void()>& read) {
  const auto refuse = [&](const std::string& reason) {
    return Failure(runtime::kExitBadUsage, context + ": " + reason);
  };
  try {
    read();
  } catch (const sample::NoSuchMember& error) {
    throw refuse(error.what() + did_you_mean(error.name(), error.known()));
  } catch (const sample::Error& error) {
    throw refuse(error.what());
  }
}

}  // namespace scarab::topic
