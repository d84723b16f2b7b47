#include "tests/system/stack.hpp"

namespace scarab::test {

Stack::Stack(const std::filesystem::path& directory, const Options& options)
    : directory_(directory), options_(options) {
  std::filesystem::create_directories(directory_);
  std::vector<Key> keys;
  for (const std::string service : {"logger", "plant", "supervisor", "premotor"}) {
    const auto replicas = options.replicas.find(service);
    const unsigned count = replicas == options.replicas.end() ? 1 : replicas->second;
    for (std::uint32_t i = 0; i < count; ++i) keys.emplace_back(service, i);
    const unsigned witnesses = service == "logger" && options.witness ? 1 : 0;
    expect_ += (expect_.empty() ? "" : ",") + service + "=" + std::to_string(count + witnesses);
  }
  for (const Key& key : keys) {
    if (options.others.count(key.first) == 0) services_.emplace(key, launch(key));
  }
}

Stack::~Stack() {
  for (auto& [key, child] : services_) child.kill();
}

ChildProcess Stack::launch(const Key& key) const {
  Arguments more;
  if (key.first == "logger") more = {"--output", log()};
  if (key.first == "plant" && options_.real_time) more = {"--pace", "realtime"};
  const Host& host = key.first == "plant" ? options_.plant_host : options_.host;
  return start({key.first, expect_, directory_, key.second, more, options_.robot, host});
}

ChildProcess& Stack::service(const std::string& name, std::uint32_t instance) {
  return services_.at({name, instance});
}

void Stack::kill(const std::string& name, std::uint32_t instance) {
  service(name, instance).kill();
}

void Stack::restart(const std::string& name, std::uint32_t instance) {
  const Key key{name, instance};
  services_.erase(key);
  services_.emplace(key, launch(key));
}

ChildProcess Stack::conduct(const Arguments& options, const std::filesystem::path& input) const {
  Arguments command = command_on(options_.host, "scarab-experiment");
  command.insert(command.end(), {"--expect", expect_});
  command.insert(command.end(), options.begin(), options.end());
  return {command, directory_ / "experiment", input};
}

bool Stack::stop() {
  bool clean = true;
  const auto stop_all = [&](bool loggers) {
    for (auto& [key, child] : services_) {
      if ((key.first == "logger") != loggers || !child.running()) continue;
      clean = child.stop(std::chrono::seconds(20)) == 0 && clean;
    }
  };
  stop_all(false);
  stop_all(true);
  return clean;
}

std::string Stack::errors() const {
  std::string text;
  for (const auto& [key, child] : services_) {
    text += "--- " + key.first + "/" + std::to_string(key.second) + "\n" + child.err();
  }
  return text;
}

Arguments main_trial() { return {"--strategy", "soft+hard", "--height", "0.10", "--seed", "1"}; }

Arguments simulate(const std::filesystem::path& output, const Arguments& trial,
                   const std::string& robot) {
  Arguments command = {program("scarab-sim"), "--output", output};
  for (const std::string folder : {"robot", "plant", "premotor", "supervisor"}) {
    command.push_back("--" + folder);
    command.push_back(source_file("config/" + folder + "/" + robot + ".yaml"));
  }
  command.insert(command.end(), trial.begin(), trial.end());
  return command;
}

}  // namespace scarab::test
