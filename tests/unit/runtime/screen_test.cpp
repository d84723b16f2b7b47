#include "common/runtime/screen.hpp"

#include <gmock/gmock.h>

#include <functional>

namespace scarab::runtime {
namespace {

using testing::HasSubstr;
using testing::Not;

/// What a screen prints where stdout is a file.
std::string printed(bool quiet, const std::function<void(Screen&)>& use) {
  testing::internal::CaptureStdout();
  {
    Screen screen(quiet);
    use(screen);
  }
  return testing::internal::GetCapturedStdout();
}

TEST(ScreenOffTerminal, LinesAndDetailsStay) {
  EXPECT_EQ(printed(false,
                    [](Screen& screen) {
                      screen.detail("detail");
                      screen.line("line");
                    }),
            "detail\nline\n");
}

TEST(ScreenOffTerminal, ProgressIsALineOfItsOwnAndThinnedOut) {
  const auto text = printed(false, [](Screen& screen) {
    for (int i = 0; i < 1000; ++i) screen.progress("progress " + std::to_string(i));
  });
  EXPECT_EQ(text, "progress 0\n");
}

TEST(ScreenOffTerminal, HasNoControlCharacters) {
  const auto text = printed(false, [](Screen& screen) {
    screen.progress("progress");
    screen.line("line");
  });
  EXPECT_THAT(text, Not(HasSubstr("\033")));
  EXPECT_THAT(text, Not(HasSubstr("\r")));
}

TEST(ScreenOffTerminal, QuietKeepsOnlyLines) {
  EXPECT_EQ(printed(true,
                    [](Screen& screen) {
                      screen.detail("detail");
                      screen.progress("progress");
                      screen.line("line");
                    }),
            "line\n");
}

}  // namespace
}  // namespace scarab::runtime
