#include "services/robot_bridge/calibrate/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>

#include "common/runtime/program.hpp"
#include "services/robot_bridge/calibrate/bench.hpp"
#include "services/robot_bridge/calibrate/by_hand.hpp"
#include "services/robot_bridge/calibrate/by_keys.hpp"
#include "services/robot_bridge/calibrate/record.hpp"
#include "services/robot_bridge/calibrate/terminal_console.hpp"
#include "services/robot_bridge/calibrate/words.hpp"

namespace scarab::bridge::calibrate {
namespace {

using Joints = std::vector<std::size_t>;

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  localtime_r(&now, &parts);
  return fmt::format("{:04}-{:02}-{:02}", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday);
}

std::string entry_words(std::size_t joint, const JointCalibration& c) {
  return fmt::format("{}: offset {:+.4f}, direction {:+d}, servo {:+.3f} to {:+.3f} rad",
                     robot::kJointNames[joint], c.offset_rad, c.direction, c.min_rad, c.max_rad);
}

/// One run of the program.
class Run {
 public:
  explicit Run(const Request& request)
      : request_(request),
        bench_(request),
        record_(request.output.empty() ? std::filesystem::path(bench_.config().calibration)
                                       : request.output),
        asked_(asked_joints(request, bench_.robot())) {
    bench_.set_up(record_.calibration());
    if ((request.yes || request.check) && !bench_.tells_angles()) {
      throw BadRequest(request.check ? "--check" : "--yes",
                       "this robot does not tell where its joints are");
    }
  }

  int go() {
    if (request_.check || request_.yes) require_entries();
    if (!request_.check && !request_.yes && to_do().empty()) return nothing_to_do();
    bench_.driver().open();
    console_.line("Robot found: " + bench_.driver().capabilities().link + ".");
    if (request_.check) return compare();
    if (request_.yes) return take_present_pose();
    return ask();
  }

 private:
  [[nodiscard]] const std::optional<JointCalibration>& known(std::size_t joint) const {
    return record_.calibration().joints[joint];
  }

  [[nodiscard]] Joints to_do() const {
    Joints joints;
    for (const std::size_t joint : asked_) {
      if (request_.again || !known(joint)) joints.push_back(joint);
    }
    return joints;
  }

  int nothing_to_do() {
    for (const std::size_t joint : asked_) console_.line(entry_words(joint, *known(joint)));
    console_.line(fmt::format("All {} joints have an entry in {}. --again does them anew.",
                              asked_.size(), record_.path().string()));
    return runtime::kExitSuccess;
  }

  void require_entries() const {
    for (const std::size_t joint : asked_) {
      if (known(joint)) continue;
      throw BadRequest(request_.check ? "--check" : "--yes",
                       std::string(robot::kJointNames[joint]) + " has no entry in " +
                           record_.path().string() + ": its direction and range are found by hand");
    }
  }

  void save(std::size_t joint, const JointCalibration& c) {
    record_.set(joint, c, fmt::format("{}, {} pose", today(), request_.pose));
    console_.line(entry_words(joint, c));
    const robot::Joint& model = bench_.robot().joints[joint];
    if (covers(c, model)) return;
    const JointRange range = reach(c);
    console_.line(
        fmt::format("  note: reaches {:+.3f} to {:+.3f} of the joint's {:+.3f} to {:+.3f} rad",
                    range.min_rad, range.max_rad, model.min_rad, model.max_rad));
  }

  int take_present_pose() {
    std::size_t done = 0;
    for (const std::size_t joint : asked_) {
      JointCalibration c = *known(joint);
      const double servo_rad = servo_angle(bench_.driver(), joint);
      c.offset_rad = offset_of(servo_rad, c.direction, bench_.reference_rad()[joint]);
      if (c.offset_rad < c.min_rad || c.offset_rad > c.max_rad) {
        console_.line(
            fmt::format("{}: not written: with the servo at {} the joint's zero would be "
                        "beyond the servo's range",
                        robot::kJointNames[joint], angle_words(servo_rad)));
        continue;
      }
      save(joint, c);
      ++done;
    }
    return summary(done, asked_.size() - done);
  }

  int compare() {
    if (!request_.yes) {
      console_.line("Put the robot into its " + request_.pose + " pose. Enter: it stands so.");
      Key key = Key::kNone;
      while (key != Key::kEnter && key != Key::kQuit) key = console_.key(kPatience);
      if (key == Key::kQuit) return runtime::kExitFailure;
    }
    std::size_t off = 0;
    for (const std::size_t joint : asked_) {
      const double read_rad = to_joint_rad(*known(joint), servo_angle(bench_.driver(), joint));
      const double wanted_rad = bench_.reference_rad()[joint];
      const bool fits = std::abs(read_rad - wanted_rad) <= request_.tolerance_rad;
      if (!fits) ++off;
      console_.line(fmt::format("{}: {} where it should be {}{}", robot::kJointNames[joint],
                                angle_words(read_rad), angle_words(wanted_rad),
                                fits ? "" : "  <- off"));
    }
    console_.line(fmt::format("{} of {} joints are off by more than {} rad.", off, asked_.size(),
                              request_.tolerance_rad));
    return off == 0 ? runtime::kExitSuccess : runtime::kExitFailure;
  }

  int ask() {
    const Calibration before = record_.calibration();
    ByHand by_hand(bench_.driver(), console_, bench_.reference_rad());
    ByKeys by_keys(bench_.driver(), console_, bench_.robot(), bench_.scales(), before,
                   bench_.reference_rad());
    if (bench_.tells_angles()) {
      console_.line("Motors are off. Keys: Enter, s: skip this joint, q: stop here.");
    } else if (!by_keys.power()) {
      return runtime::kExitFailure;
    }
    return work_through([&](std::size_t joint) {
      return bench_.tells_angles() ? by_hand.find(joint) : by_keys.find(joint);
    });
  }

  int work_through(const std::function<Finding(std::size_t)>& find) {
    const Joints joints = to_do();
    for (const std::size_t joint : asked_) {
      if (request_.again || !known(joint)) continue;
      console_.line(entry_words(joint, *known(joint)) + " (done)");
    }
    std::size_t done = 0;
    for (const std::size_t joint : joints) {
      const Finding finding = find(joint);
      if (finding.outcome == Finding::Outcome::kQuit) break;
      if (finding.outcome != Finding::Outcome::kFound) continue;
      save(joint, finding.calibration);
      ++done;
    }
    return summary(done, joints.size() - done);
  }

  int summary(std::size_t done, std::size_t left) {
    console_.line(
        fmt::format("{} of {} joints written to {}.", done, done + left, record_.path().string()));
    return left == 0 ? runtime::kExitSuccess : runtime::kExitFailure;
  }

  static constexpr std::chrono::milliseconds kPatience{200};

  Request request_;
  TerminalConsole console_;
  Bench bench_;
  Record record_;
  Joints asked_;
};

}  // namespace

int calibrate(const Request& request) { return Run(request).go(); }

}  // namespace scarab::bridge::calibrate
