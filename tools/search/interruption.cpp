#include "tools/search/interruption.hpp"

#include <csignal>

namespace scarab::search {
namespace {

std::atomic<bool> interrupted{false};

void interrupt(int) { interrupted = true; }

}  // namespace

const std::atomic<bool>& watch_for_interruption() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

}  // namespace scarab::search
