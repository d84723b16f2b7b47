#include "tools/log/progress_line.hpp"

#include <unistd.h>

#include <cstdio>

namespace scarab::log {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPeriod{200};

}  // namespace

ProgressLine::ProgressLine(std::string what)
    : what_(std::move(what)), terminal_(::isatty(STDERR_FILENO) == 1), last_(Clock::now()) {}

ProgressLine::~ProgressLine() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

bool ProgressLine::is_due() {
  if (!terminal_ || Clock::now() - last_ < kPeriod) return false;
  last_ = Clock::now();
  return true;
}

void ProgressLine::update(std::uint64_t done, std::uint64_t total) {
  constexpr std::uint64_t kPercent = 100;
  if (total == 0 || !is_due()) return;
  std::fprintf(stderr, "\r\x1b[K%s: %u %%", what_.c_str(),
               static_cast<unsigned>(done * kPercent / total));
  shown_ = true;
}

void ProgressLine::say(const std::string& text) {
  if (!is_due()) return;
  std::fprintf(stderr, "\r\x1b[K%s: %s", what_.c_str(), text.c_str());
  shown_ = true;
}

}  // namespace scarab::log
