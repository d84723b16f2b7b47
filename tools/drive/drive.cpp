#include "tools/drive/drive.hpp"

#include <chrono>
#include <clocale>
#include <iostream>

#include "common/bus/error.hpp"
#include "common/runtime/program.hpp"
#include "tools/drive/stack.hpp"
#include "tools/drive/terminal.hpp"
#include "tools/drive/view.hpp"

namespace scarab::drive {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kKeyPoll{20};  // a key waits no longer, nor does a redraw
constexpr std::chrono::milliseconds kShowPeriod{100};

/// The person at the terminal: turns keys into orders, and says why one is not given.
class Driver {
 public:
  Driver(const DriveOptions& options, Stack& stack)
      : options_(options), stack_(stack), wants_trial_(options.start_trial) {
    if (!wants_trial_) notice_.text = "? shows all keys";
  }

  /// False: the person has quit.
  bool press(Key key, Terminal& terminal) {
    const Action action = drive::press(keyboard_, key, stack_.live().inputs, options_.strategies);
    switch (action.kind) {
      case Action::Kind::kNothing:
        break;
      case Action::Kind::kOrder:
        give(action.order);
        break;
      case Action::Kind::kTrial:
        wants_trial_ = true;
        break;
      case Action::Kind::kRedraw:
        terminal.redraw();
        break;
      case Action::Kind::kQuit:
        return false;
    }
    return true;
  }

  /// Looks what became of orders, and tells a trial that is wanted once everybody is there.
  void go_on() {
    if (const auto news = stack_.news_of_order()) notice_ = *news;
    if (!stack_.order_is_open()) follow(keyboard_, stack_.live().inputs);
    if (wants_trial_) tell_trial();
  }

  [[nodiscard]] std::vector<Line> view(Size size) const {
    return draw(stack_.live(), keyboard_, options_.strategies, notice_, size);
  }

 private:
  void give(const Order& order) {
    const bool stops_or_resets =
        order.command == scarab_OPERATOR_EMERGENCY_STOP || order.command == scarab_OPERATOR_RESET;
    if (!stops_or_resets && !stack_.live().trial_runs) {
      keyboard_.by_hand.reset();
      notice_ = {order.name + ": no trial runs; t starts one", Concern::kWaits};
      return;
    }
    try {
      stack_.say(order);
      notice_ = stack_.live().tick_master.empty()
                    ? Notice{order.name + ": no tick master is there; it is for the first to come",
                             Concern::kFault}
                    : Notice{order.name + " ...", Concern::kNone};
    } catch (const bus::Error& error) {  // the driver must keep the wheel
      notice_ = {order.name + ": " + error.what(), Concern::kFault};
    }
  }

  void tell_trial() {
    if (stack_.live().trial_runs) {
      wants_trial_ = false;
      notice_ = {"trial: trial " + std::to_string(stack_.live().trial) + " runs already",
                 Concern::kWaits};
      return;
    }
    if (stack_.trial_is_starting()) {
      wants_trial_ = false;
      return;
    }
    const std::string missing = stack_.missing_for_trial();
    if (!missing.empty()) {
      notice_ = {"trial: waits for " + missing, Concern::kWaits};
      return;
    }
    wants_trial_ = false;
    const auto number = stack_.tell_trial(options_.trial);
    notice_ = {"trial " + std::to_string(number) + " told: strategy " + options_.trial.strategy,
               Concern::kNone};
  }

  const DriveOptions& options_;
  Stack& stack_;
  Keyboard keyboard_;
  Notice notice_;
  bool wants_trial_;
};

/// False: SIGINT or SIGTERM came.
bool run(Driver& driver, Stack& stack) {
  Terminal terminal;
  auto shown = Clock::time_point{};
  while (stack.wait(kKeyPoll)) {
    driver.go_on();
    bool pressed = false;
    while (const auto key = terminal.key()) {
      pressed = true;
      if (!driver.press(*key, terminal)) return true;
    }
    if (!pressed && Clock::now() - shown < kShowPeriod) continue;
    shown = Clock::now();
    terminal.show(driver.view(terminal.size()));
  }
  return false;
}

/// What is left behind.
void say_goodbye(const Stack& stack) {
  const Live& live = stack.live();
  std::cout << "scarab-drive: the stack stays as it is";
  if (live.trial_runs) {
    std::cout << ": trial " << live.trial << " goes on (" << live.phase << ", " << live.state
              << ", mode " << live.mode << ")";
  } else if (live.safe_stop) {
    std::cout << ": no trial runs, and the safe stop holds until a reset";
  } else if (!live.tick_master_answers && !live.tick_master.empty()) {
    std::cout << ", but " << live.tick_master << " does not answer";
  }
  std::cout << '\n';
  if (stack.runs_own_trial()) {
    std::cout << "scarab-drive: trial " << live.trial
              << " was told here: a service that is restarted from now on cannot join it "
                 "(scarab-operator stop ends it)\n";
  }
}

int refuse(const std::string& why) {
  std::cerr << "scarab-drive: " << why << '\n';
  return runtime::kExitBadUsage;
}

}  // namespace

runtime::TrialOptions trial_to_drive_in() {
  runtime::TrialOptions options;
  options.strategy = "stand";
  options.goal = "none";
  options.height_m = 0;
  options.time_limit_s = 3600;
  return options;
}

int drive(const DriveOptions& options) {
  if (!has_terminal()) {
    return refuse("needs a terminal: stdin and stdout are to be one (scarab-operator needs none)");
  }
  const auto size = terminal_size();
  if (size && (size->columns < kSmallest.columns || size->rows < kSmallest.rows)) {
    return refuse(too_small(*size));
  }
  // Names and reasons may be UTF-8; numbers keep their point.
  std::setlocale(LC_CTYPE, "");  // NOLINT(concurrency-mt-unsafe): no other thread yet
  Stack stack(options.bus);
  Driver driver(options, stack);
  try {
    const bool quit = run(driver, stack);
    say_goodbye(stack);
    return quit ? runtime::kExitSuccess : runtime::kExitInterrupted;
  } catch (const UnknownTerminal& unknown) {
    return refuse(unknown.what());
  }
}

}  // namespace scarab::drive
