#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>

#include "tests/integration/emulator/emulator_process.hpp"
#include "tests/integration/emulator/line.hpp"

/// The robot answers in time, whatever keeps the rest of the emulator.
namespace scarab::test {
namespace {

constexpr int kSmallestPipe = 4096;  // bytes: some hundred lines of the journal

/// A file that takes no more than a few lines until somebody reads them: a disk that stalls.
class StalledFile {
 public:
  explicit StalledFile(const std::filesystem::path& path) {
    EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
    fd_ = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    EXPECT_EQ(::fcntl(fd_, F_SETPIPE_SZ, kSmallestPipe), kSmallestPipe);
  }
  ~StalledFile() { ::close(fd_); }
  StalledFile(const StalledFile&) = delete;
  StalledFile& operator=(const StalledFile&) = delete;

  /// What has come since the last call.
  std::string read() {
    std::string text;
    std::array<char, kSmallestPipe> block{};
    for (ssize_t size = 0; (size = ::read(fd_, block.data(), block.size())) > 0;) {
      text.append(block.data(), static_cast<std::size_t>(size));
    }
    return text;
  }

 private:
  int fd_ = -1;
};

TEST(EmulatorUnderLoad, AnswersWhileItsJournalStalls) {
  const TemporaryDirectory directory;
  StalledFile stalled(directory / "journal.csv");
  ChildProcess emulator(emulator_command(directory.path()), directory / "emulator-0");
  const auto device = directory / "device";
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(device) || !emulator.running(); }));
  ASSERT_TRUE(emulator.running()) << emulator.err();
  DynamixelLine line(device);
  const auto& goal = DynamixelLine::kModel.goal_position;
  constexpr int kGoals = 400;  // a line of some 40 bytes each
  for (int i = 0; i < kGoals; ++i) ASSERT_TRUE(line.write(1, goal, 2000 + i)) << i;
  EXPECT_TRUE(line.ask(dxl::ping(1)));
  std::string journal;  // whole: a line may come in two parts
  const auto told = [&] {
    journal += stalled.read();
    int count = 0;
    for (std::size_t at = 0; (at = journal.find(",goal,TL0", at)) != std::string::npos; ++at) {
      ++count;
    }
    return count;
  };
  EXPECT_TRUE(eventually([&] { return told() == kGoals; })) << journal;
  EXPECT_EQ(emulator.stop(), 0) << emulator.err();
}

}  // namespace
}  // namespace scarab::test
