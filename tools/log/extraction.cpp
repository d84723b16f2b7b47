#include "tools/log/extraction.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace scarab::log {
namespace {

bool stays_inside(const std::filesystem::path& name) {
  return !name.empty() && !name.is_absolute() &&
         std::none_of(name.begin(), name.end(), [](const auto& part) { return part == ".."; });
}

}  // namespace

std::vector<std::filesystem::path> extract_attachments(const mcap::Reader& reader,
                                                       const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const mcap::AttachmentIndex& index : reader.summary().attachments) {
    if (!stays_inside(index.name)) {
      throw std::runtime_error("attachment " + index.name + " would be written outside of " +
                               folder.string());
    }
    const auto path = folder / index.name;
    std::filesystem::create_directories(path.parent_path());
    const mcap::Attachment attachment = reader.attachment(index);
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file.write(reinterpret_cast<const char*>(attachment.data.data()),
               static_cast<std::streamsize>(attachment.data.size()));
    file.close();
    if (!file) throw std::runtime_error("cannot write " + path.string());
    files.push_back(path);
  }
  return files;
}

}  // namespace scarab::log
