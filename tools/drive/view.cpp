#include "tools/drive/view.hpp"

#include <algorithm>
#include <cstdint>

#include "tools/drive/pages.hpp"

namespace scarab::drive {
namespace {

constexpr std::size_t kBarColumns = 34;
constexpr std::size_t kServicesMost = 5;
constexpr std::array<const char*, 3> kJointLetters = {"T", "C", "F"};  // in the order of LegJoint

std::string decimal(double value, int decimals) {
  const std::string text = figure(value, decimals);
  return text.front() == '+' ? text.substr(1) : text;
}

std::string milliseconds(double seconds) { return decimal(seconds * 1e3, 1) + " ms"; }

Style style_of(Concern concern) {
  switch (concern) {
    case Concern::kNone:
      return Style::kPlain;
    case Concern::kWaits:
    case Concern::kDegraded:
      return Style::kWarning;
    case Concern::kFault:
      return Style::kAlarm;
  }
  return Style::kPlain;
}

Line title(const Live& live) {
  Line line = {{"Scarab", Style::kBold}, {"  " + live.where + "  ", Style::kDim}};
  if (live.tick_master.empty()) {
    line.push_back({"no tick master (plant or robot bridge) is there", Style::kWarning});
  } else if (!live.tick_master_answers) {
    line.push_back({"tick master " + live.tick_master + " does not answer", Style::kAlarm});
  } else {
    const char* pace = live.trial == 0 ? "" : live.real_time ? ", real time" : ", lockstep";
    line.push_back({"tick master " + live.tick_master + pace});
  }
  return line;
}

Line trial(const Live& live) {
  if (live.trial == 0) return {{"no trial yet: t starts one", Style::kDim}};
  Line line = {{"trial " + std::to_string(live.trial) + "  tick " + std::to_string(live.tick) +
                    "  " + decimal(live.time_s, 1) + " s  " + decimal(live.ticks_per_s, 1) +
                    " ticks/s  ",
                Style::kPlain}};
  if (live.trial_runs) {
    line.push_back({live.phase, live.phase == "running" ? Style::kGood : Style::kWarning});
  } else if (!live.tick_master_answers) {
    line.push_back({live.phase + " when last heard of", Style::kWarning});
  } else {
    line.push_back({live.phase + "; no trial runs: t starts one", Style::kDim});
  }
  return line;
}

Line behaviour(const Live& live) {
  if (live.state.empty()) return {{"no behaviour heard of yet", Style::kDim}};
  const bool manual = live.state == "manual";
  return {{"behaviour ", Style::kDim},
          {padded(live.state, 11), manual ? Style::kWarning : Style::kBold},
          {"mode ", Style::kDim},
          {padded(live.mode, 12), Style::kBold}};
}

/// A service's message without the word that the banner already has.
std::string after(const std::string& message, const std::string& start) {
  return message.compare(0, start.size(), start) == 0 ? message.substr(start.size()) : message;
}

/// What must not be overlooked.
Line banner(const Live& live) {
  if (live.safe_stop) {
    const std::string why = after(live.tick_master_says, "safe stop: ");
    return {{" SAFE STOP  " + why + "; r resets ", Style::kAlarm}};
  }
  if (live.phase == "homing" && live.trial_runs) {
    return {{" HOMING  " + after(live.tick_master_says, "homing: ") + " ", Style::kWarning}};
  }
  return {};
}

Line inputs(const Live& live, const Keyboard& keyboard) {
  Line line;
  for (std::size_t i = 0; i < live.inputs.size(); ++i) {
    const bool selected = i == keyboard.selected_input;
    line.push_back({"I" + std::to_string(i + 1), selected ? Style::kSelected : Style::kDim});
    line.push_back({" " + figure(live.inputs[i], 2) + " " + signed_bar(live.inputs[i], 9) + "  "});
  }
  return line;
}

Line signal(const std::string& name, double value, const std::string& unit, double threshold,
            double low, double high, const std::string& meaning) {
  return {{name + " ", Style::kDim},
          {figure(value, 3) + " " + unit + " "},
          {bar(value, low, high, threshold, kBarColumns)},
          {" | " + decimal(threshold, 3) + " " + meaning, Style::kDim}};
}

Line bs(const Live& live) {
  const double threshold = live.bs_threshold_rad;
  const bool above = live.bs_rad > threshold && !live.state.empty();
  return signal("BS", live.bs_rad, "rad", threshold, 0, std::max(2 * threshold, 0.01),
                above ? "above: on it" : "inclination");
}

Line as(const Live& live) {
  const double threshold = live.as_threshold_rad;
  const bool below = live.as_rad < threshold && !live.state.empty();
  return signal("AS", live.as_rad, "rad", threshold, threshold - 0.2, threshold + 0.2,
                below ? "below: blocked" : "front F-joints");
}

/// The load that tells of the obstacle where AS does not.
Line load(const Live& live) {
  const double threshold = live.trigger_threshold;
  const bool above = live.trigger_value > threshold && !live.state.empty();
  const std::string name = live.trigger_unit == "N" ? "FS" : "IS";
  return signal(name, live.trigger_value, live.trigger_unit, threshold, 0, 2 * threshold,
                above ? "above: blocked" : live.trigger);
}

std::string angle(const Live& live, std::size_t slot) {
  const std::string text = live.has_joint[slot] ? figure(live.position_rad[slot], 2) : "-";
  return std::string(8 - std::min<std::size_t>(8, text.size()), ' ') + text;
}

std::vector<Line> joints(const Live& live) {
  Line head = {{"rad  ", Style::kDim}};
  for (const auto name : robot::kLegNames) {
    head.push_back({"      " + std::string(name), Style::kDim});
  }
  head.push_back({"      BJ", Style::kDim});
  std::vector<Line> lines = {head};
  using robot::LegJoint;
  for (std::size_t row = 0; row < kJointLetters.size(); ++row) {
    Line line = {{std::string(kJointLetters[row]) + "    ", Style::kDim}};
    for (const auto leg : robot::kLegs) {
      line.push_back({angle(live, robot::joint_slot(leg, static_cast<LegJoint>(row)))});
    }
    if (row == 0) line.push_back({angle(live, robot::kBackboneSlot)});
    lines.push_back(line);
  }
  return lines;
}

Line refused(const Live& live) {
  std::string text;
  for (const auto& [why, count] : live.refused) text += " " + why + " " + std::to_string(count);
  return {{"refused  ", Style::kDim},
          {text.empty() ? "no command" : "commands:" + text,
           text.empty() ? Style::kPlain : Style::kWarning},
          {"  clamped " + std::to_string(live.clamped), Style::kDim}};
}

Line timing(const Live& live) {
  Line line = {{"timing   ", Style::kDim},
               {"command age p99 " + milliseconds(live.timing.command_age_p99_s) + " max " +
                milliseconds(live.timing.command_age_max_s)}};
  if (!live.real_time) return line;
  line.push_back({"  tick jitter p99 " + milliseconds(live.timing.jitter_p99_s) + " max " +
                  milliseconds(live.timing.jitter_max_s)});
  return line;
}

std::vector<Line> services(const Live& live) {
  std::vector<Line> lines;
  for (const auto& service : live.services) {
    if (lines.size() == kServicesMost) break;
    lines.push_back({{padded(service.name, 14)},
                     {padded(service.lifecycle, 10), Style::kDim},
                     {service.message, style_of(service.concern)}});
  }
  while (lines.size() < kServicesMost) lines.emplace_back();
  return lines;
}

std::vector<Line> main_page(const Live& live, const Keyboard& keyboard, const Notice& notice) {
  std::vector<Line> lines = {title(live),
                             trial(live),
                             behaviour(live),
                             {{"because   ", Style::kDim}, {live.reason}},
                             banner(live),
                             inputs(live, keyboard),
                             bs(live),
                             live.by_load ? load(live) : as(live),
                             {}};
  const auto append = [&lines](const std::vector<Line>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
  };
  append(joints(live));
  append({refused(live), timing(live)});
  append(services(live));
  append({{{notice.text, style_of(notice.concern)}}});
  append(key_lines(keyboard));
  return lines;
}

}  // namespace

std::string too_small(Size size) {
  const auto phrase = [](Size of) {
    return std::to_string(of.columns) + " x " + std::to_string(of.rows);
  };
  return "needs a terminal of " + phrase(kSmallest) + ", this one has " + phrase(size);
}

std::vector<Line> draw(const Live& live, const Keyboard& keyboard,
                       const std::vector<std::string>& strategies, const Notice& notice,
                       Size size) {
  std::vector<Line> lines;
  if (size.columns < kSmallest.columns || size.rows < kSmallest.rows) {
    lines = {{{too_small(size), Style::kWarning}}, {{"SPACE is the emergency stop all the same"}}};
  } else if (keyboard.page == Page::kHelp) {
    lines = help_page();
  } else if (keyboard.page == Page::kStrategies) {
    lines = strategies_page(keyboard, strategies, size.rows);
  } else {
    lines = main_page(live, keyboard, notice);
  }
  if (lines.size() > size.rows) lines.resize(size.rows);
  for (Line& line : lines) line = fit(line, size.columns);
  return lines;
}

}  // namespace scarab::drive
