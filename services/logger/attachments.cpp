#include "services/logger/attachments.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "common/bus/clock.hpp"

namespace scarab::logger {
namespace {

std::string media_type_of(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".yaml" || extension == ".yml") return "application/yaml";
  if (extension == ".json") return "application/json";
  if (extension == ".xml" || extension == ".urdf") return "application/xml";
  if (extension == ".txt" || extension == ".log" || extension == ".csv") return "text/plain";
  return "application/octet-stream";
}

std::uint64_t changed_ns(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0) return 0;
  return static_cast<std::uint64_t>(status.st_mtim.tv_sec) * 1'000'000'000U +
         static_cast<std::uint64_t>(status.st_mtim.tv_nsec);
}

}  // namespace

mcap::Attachment load_attachment(const std::filesystem::path& file, const std::string& name) {
  std::ifstream stream(file, std::ios::binary);
  mcap::Attachment attachment{static_cast<std::uint64_t>(bus::now_ns()), changed_ns(file), name,
                              media_type_of(file),
                              mcap::Bytes(std::istreambuf_iterator<char>(stream), {})};
  if (!stream) {
    throw std::runtime_error("cannot read " + file.string() + " to attach it");
  }
  return attachment;
}

std::vector<mcap::Attachment> load_attachments(const std::vector<std::filesystem::path>& files,
                                               const std::filesystem::path& run_dir) {
  std::vector<mcap::Attachment> attachments;
  for (const auto& file : files) {
    attachments.push_back(load_attachment(file, file.filename().string()));
  }
  const auto config = run_dir / "config";
  if (run_dir.empty() || !std::filesystem::is_directory(config)) return attachments;
  std::vector<std::filesystem::path> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(config)) {
    if (entry.is_regular_file()) found.push_back(entry.path());
  }
  std::sort(found.begin(), found.end());
  for (const auto& file : found) {
    attachments.push_back(load_attachment(file, file.lexically_relative(run_dir).generic_string()));
  }
  return attachments;
}

}  // namespace scarab::logger
