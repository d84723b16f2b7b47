#include "tools/log/mended_copy.hpp"

#include <algorithm>

#include "common/mcap/recover.hpp"

namespace scarab::log {
namespace {

std::filesystem::path folder_of(const mcap::Reader& file) {
  return std::filesystem::absolute(file.path()).lexically_normal().parent_path();
}

bool says_so(const mcap::Reader& copy, const mcap::Reader& original) {
  const auto& metadata = copy.summary().metadata;
  return std::any_of(metadata.begin(), metadata.end(), [&](const mcap::MetadataIndex& index) {
    if (index.name != mcap::kRecovered) return false;
    const mcap::Metadata record = copy.metadata(index);
    const auto from = record.entries.find(mcap::kRecoveredFrom);
    return from != record.entries.end() && from->second == original.path().filename();
  });
}

}  // namespace

bool is_mended_copy(const mcap::Reader& copy, const mcap::Reader& original) {
  const mcap::Statistics& a = copy.summary().statistics;
  const mcap::Statistics& b = original.summary().statistics;
  return &copy != &original && folder_of(copy) == folder_of(original) && says_so(copy, original) &&
         a.message_count == b.message_count && a.start_time_ns == b.start_time_ns &&
         a.end_time_ns == b.end_time_ns;
}

}  // namespace scarab::log
