#include "tests/system/keeper.hpp"

#include <algorithm>
#include <thread>

namespace scarab::test {

void Keeper::kill(const std::string& service, std::uint32_t instance) {
  constexpr std::chrono::milliseconds kFirst{100};
  constexpr std::chrono::milliseconds kLongest{5000};
  const Process process{service, instance};
  while (due_.count(process) != 0) look_after(std::chrono::milliseconds(1));
  stack_.kill(service, instance);
  const auto wait = std::min(kLongest, kFirst * (1U << kills_[process]));
  ++kills_[process];
  due_[process] = Clock::now() + wait;
}

void Keeper::restart_due() {
  for (auto entry = due_.begin(); entry != due_.end();) {
    if (Clock::now() < entry->second) {
      ++entry;
      continue;
    }
    stack_.restart(entry->first.first, entry->first.second);
    entry = due_.erase(entry);
  }
}

void Keeper::look_after(std::chrono::microseconds duration) {
  const auto end = Clock::now() + duration;
  while (Clock::now() < end) {
    restart_due();
    std::this_thread::sleep_for(std::chrono::microseconds(50));
  }
}

void Keeper::restart_all() {
  for (auto& [process, due] : due_) due = Clock::time_point{};
  restart_due();
}

unsigned Keeper::kills_of(const std::string& service, std::uint32_t instance) const {
  const auto entry = kills_.find({service, instance});
  return entry == kills_.end() ? 0 : entry->second;
}

}  // namespace scarab::test
