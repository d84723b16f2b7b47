#include "tools/log/extraction.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace scarab::log {
namespace {

bool stays_inside(const std::filesystem::path& name) {
  return !name.empty() && !name.is_absolute() &&
         std::none_of(name.begin(), name.end(), [](const auto& part) { return part == ".."; });
}

/// Files of one recording carry the same attachments: one that is there already is no other.
void check_place(const mcap::Attachment& attachment, const std::filesystem::path& folder) {
  if (!stays_inside(attachment.name)) {
    throw std::runtime_error("attachment " + attachment.name + " would be written outside of " +
                             folder.string());
  }
  const auto path = folder / attachment.name;
  if (!std::filesystem::exists(path)) return;
  std::ifstream file(path, std::ios::binary);
  const std::string there{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const auto* data = reinterpret_cast<const char*>(attachment.data.data());
  if (there != std::string_view(data, attachment.data.size())) {
    throw std::runtime_error("cannot create " + path.string() + ": it exists, with other content");
  }
}

}  // namespace

std::vector<std::filesystem::path> extract_attachments(const mcap::Reader& reader,
                                                       const std::filesystem::path& folder) {
  // Before the first is written.
  for (const mcap::AttachmentIndex& index : reader.summary().attachments) {
    check_place(reader.attachment(index), folder);
  }
  std::vector<std::filesystem::path> files;
  for (const mcap::AttachmentIndex& index : reader.summary().attachments) {
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
