#include "services/robot_bridge/calibrate/record.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "services/robot_bridge/calibrate/calibration_text.hpp"
#include "services/robot_bridge/calibration_file.hpp"

namespace scarab::bridge::calibrate {
namespace {

std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw std::runtime_error(path.string() +
                           ": cannot be written: " + std::system_category().message(error));
}

/// On the disk, not only in its cache, on return.
void write_through(const std::filesystem::path& path, const std::string& text) {
  const int fd = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) fail(path, errno);
  const ssize_t written = write(fd, text.data(), text.size());
  const bool cut_short = written >= 0 && written < static_cast<ssize_t>(text.size());
  const bool whole = written >= 0 && !cut_short && fsync(fd) == 0;
  const int error = cut_short ? ENOSPC : errno;
  close(fd);
  if (!whole) fail(path, error);
}

}  // namespace

Record::Record(std::filesystem::path path) : path_(std::move(path)) {
  if (std::filesystem::exists(path_)) {
    calibration_ = load_calibration(path_);
    text_ = read_file(path_);
  } else {
    text_ = empty_calibration_text();
  }
}

void Record::set(std::size_t joint, const JointCalibration& c, const std::string& note) {
  const std::string text = with_entry(text_, robot::kJointNames[joint], c, note);
  std::filesystem::path draft = path_;
  draft += ".draft";
  write_through(draft, text);
  try {
    calibration_ = load_calibration(draft);
  } catch (...) {
    std::filesystem::remove(draft);
    throw;
  }
  std::filesystem::rename(draft, path_);
  text_ = text;
}

}  // namespace scarab::bridge::calibrate
