#include "services/robot_bridge/calibrate/calibration_text.hpp"

#include <fmt/format.h>

#include <vector>

namespace scarab::bridge::calibrate {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1);
    lines.push_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return lines;
}

/// `TL0:` at the left margin, with or without something behind it.
bool begins_entry(std::string_view line, std::string_view joint) {
  return line.substr(0, joint.size()) == joint && line.size() > joint.size() &&
         line[joint.size()] == ':';
}

/// Belongs to the entry above it: a block's lines are indented, a flow map's may be, too.
bool continues_entry(std::string_view line) {
  const std::size_t content = line.find_first_not_of(" \t");
  return content != 0 && content != std::string_view::npos && line[content] != '\n';
}

std::string entry(std::string_view joint, const JointCalibration& c, std::string_view note) {
  return fmt::format(
      "{}: {{offset_rad: {:.4f}, direction: {}, min_rad: {:.4f}, max_rad: {:.4f}}}  # {}\n", joint,
      c.offset_rad, c.direction, c.min_rad, c.max_rad, note);
}

}  // namespace

std::string with_entry(const std::string& text, std::string_view joint, const JointCalibration& c,
                       std::string_view note) {
  std::string result;
  bool written = false;
  bool inside = false;
  for (const std::string_view line : lines_of(text)) {
    inside = begins_entry(line, joint) || (inside && continues_entry(line));
    if (!inside) {
      result += line;
    } else if (!written) {
      result += entry(joint, c, note);
      written = true;
    }
  }
  if (written) return result;
  if (!result.empty() && result.back() != '\n') result += '\n';
  return result + entry(joint, c, note);
}

std::string empty_calibration_text() {
  std::string text = "# How each servo sits in its joint (docs/robot-bridge.md).\n";
  for (const std::string_view joint : robot::kJointNames) {
    text += joint;
    text += ": absent\n";
  }
  return text;
}

}  // namespace scarab::bridge::calibrate
