#pragma once

#include <algorithm>
#include <chrono>
#include <iterator>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/runtime/tick_body.hpp"

namespace scarab::test {

/// A body without physics: its joints stand where they were last told, and it writes down what is
/// asked of it. The test may ask it, and tell it what happens to it, from another thread.
class RecordingBody : public runtime::TickBody {
 public:
  using Clock = std::chrono::steady_clock;
  enum class Call { kBegin, kActivate, kStart, kAdvance, kEnd, kSafeStop, kRest };
  struct Entry {
    Call call;
    Clock::time_point time;
    double target_rad = 0;  ///< of the first joint, of kAdvance
  };
  /// What happens to it.
  struct Fate {
    bool configured = true;
    bool tells_idle = false;  ///< idle() has something to tell
    double stands_rad = 0;    ///< every joint, while the motors are off
    bool stops_without_torque = false;
    std::optional<std::string> fault;
    std::optional<runtime::TrialEnd> verdict;                     ///< of a referee
    std::string activate_throws, observe_throws, advance_throws;  ///< empty: they do not
  };

  RecordingBody(std::chrono::nanoseconds period, unsigned samples)
      : period_(period), samples_(samples) {}

  template <class Change>
  void change(Change&& change) {
    const std::lock_guard lock(mutex_);
    change(fate_);
  }
  [[nodiscard]] std::vector<Entry> log() const {
    const std::lock_guard lock(mutex_);
    return log_;
  }
  [[nodiscard]] std::vector<Call> calls() const {
    std::vector<Call> calls;
    for (const Entry& entry : log()) calls.push_back(entry.call);
    return calls;
  }
  [[nodiscard]] std::size_t count(Call call) const {
    const auto all = calls();
    return static_cast<std::size_t>(std::count(all.begin(), all.end(), call));
  }
  /// The newest one of a kind.
  [[nodiscard]] std::optional<Entry> last(Call call) const {
    const auto all = log();
    const auto found =
        std::find_if(all.rbegin(), all.rend(), [&](const Entry& e) { return e.call == call; });
    return found == all.rend() ? std::nullopt : std::optional(*found);
  }

  void begin(const scarab_Trial&) override {
    note(Call::kBegin);
    end_.reset();
    time_ns_ = 0;
  }
  [[nodiscard]] bool configured() const override { return fate().configured; }
  [[nodiscard]] std::string waiting_for() const override { return "the test's device"; }
  void activate() override {
    note(Call::kActivate);
    throw_if(fate().activate_throws);
    held_rad_ = powered_ ? held_rad_ : fate().stands_rad;
    powered_ = applies_ = true;
  }
  [[nodiscard]] robot::JointVector held_rad() const override { return all(held_rad_); }
  [[nodiscard]] robot::JointVector home_rad() const override { return all(0); }
  void start() override { note(Call::kStart), time_ns_ = 0, started_ = true; }
  [[nodiscard]] std::int64_t time_ns() const override { return time_ns_; }
  void observe(scarab_RobotState& state) override {
    throw_if(fate().observe_throws);
    const double stands_rad = powered_ ? held_rad_ : fate().stands_rad;
    std::fill(std::begin(state.position_rad), std::end(state.position_rad), stands_rad);
  }
  void advance(const robot::JointVector& target_rad, const std::function<void()>& sample) override {
    note(Call::kAdvance, target_rad[0]);
    throw_if(fate().advance_throws);
    if (applies_) held_rad_ = target_rad[0];
    for (unsigned i = 1; i < samples_; ++i) sample();
    if (started_) time_ns_ += period_.count();
  }
  [[nodiscard]] std::optional<runtime::TrialEnd> verdict() const override {
    return end_ ? end_ : fate().verdict;
  }
  void end(const runtime::TrialEnd& end) override { note(Call::kEnd), end_ = end; }
  void rest() noexcept override {
    note(Call::kRest);
    powered_ = applies_ = started_ = false;
  }
  void safe_stop() noexcept override {
    note(Call::kSafeStop), applies_ = false;
    if (fate().stops_without_torque) powered_ = false;
  }
  [[nodiscard]] bool powered() const noexcept override { return powered_; }
  [[nodiscard]] std::optional<std::string> fault() const override { return fate().fault; }
  bool idle() override { return fate().tells_idle; }
  void publish_own(const scarab_Header&) override {}
  void flush_own() override {}
  void add_needs(runtime::PeerCheck&) const override {}

 private:
  static robot::JointVector all(double angle_rad) {
    robot::JointVector result{};
    result.fill(angle_rad);
    return result;
  }
  static void throw_if(const std::string& what) {
    if (!what.empty()) throw std::runtime_error(what);
  }
  [[nodiscard]] Fate fate() const {
    const std::lock_guard lock(mutex_);
    return fate_;
  }
  void note(Call call, double target_rad = 0) {
    const std::lock_guard lock(mutex_);
    log_.push_back({call, Clock::now(), target_rad});
  }

  std::chrono::nanoseconds period_;
  unsigned samples_;
  mutable std::mutex mutex_;  // of the next two
  Fate fate_;
  std::vector<Entry> log_;
  double held_rad_ = 0;
  bool powered_ = false;
  bool applies_ = false;
  bool started_ = false;
  std::int64_t time_ns_ = 0;
  std::optional<runtime::TrialEnd> end_;
};

}  // namespace scarab::test
