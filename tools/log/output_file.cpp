#include "tools/log/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

#include "common/mcap/records.hpp"
#include "tools/log/unfinished_file.hpp"

namespace scarab::log {
namespace {

bool is_log(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string start(mcap::kMagic.size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return file && std::equal(start.begin(), start.end(), mcap::kMagic.begin(), [](char a, auto b) {
           return static_cast<unsigned char>(a) == static_cast<unsigned char>(b);
         });
}

void fill(const std::filesystem::path& path, const std::filesystem::path& called,
          const std::function<void(std::ostream&)>& write) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  const int error = file ? 0 : errno;
  if (file) write(file);
  file.close();
  if (file) return;
  throw std::runtime_error("cannot write " + called.string() +
                           (error == 0 ? "" : ": " + std::generic_category().message(error)));
}

}  // namespace

void write_file(const std::filesystem::path& path,
                const std::function<void(std::ostream&)>& write) {
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path)) {
    fill(path, path, write);
    return;
  }
  if (is_log(path)) {
    throw std::invalid_argument(path.string() + " is a log; another name is meant for the table");
  }
  const auto whole = std::filesystem::weakly_canonical(path);  // a link stays one
  const UnfinishedFile unfinished(whole.string() + ".unfinished");
  fill(whole.string() + ".unfinished", path, write);
  std::filesystem::rename(whole.string() + ".unfinished", whole);
}

}  // namespace scarab::log
