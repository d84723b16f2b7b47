#include <gmock/gmock.h>

#include "tools/status/report.hpp"

namespace scarab::status {
namespace {

using testing::HasSubstr;

Snapshot one_service(runtime::ServiceReport report) {
  return {"plant/0", {{std::move(report), "beetle", {10, 1}}}};
}

TEST(StatusJson, IsOneLine) {
  runtime::ServiceReport report;
  report.message = "two\nlines";
  const std::string text = json(one_service(report));
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

TEST(StatusJson, EscapesWhatAMessageHolds) {
  runtime::ServiceReport report;
  report.message = "a \"quote\", a \\ and a \t";
  EXPECT_THAT(json(one_service(report)),
              HasSubstr("\"message\": \"a \\\"quote\\\", a \\\\ and a \\u0009\""));
}

TEST(StatusJson, HistogramsInSeconds) {
  runtime::ServiceReport report;
  for (int i = 0; i < 99; ++i) report.histograms["command_age"].add(std::chrono::microseconds(15));
  report.histograms["command_age"].add(std::chrono::milliseconds(7));
  EXPECT_THAT(json(one_service(report)),
              HasSubstr("\"command_age\": {\"count\": 100, \"p50_s\": 2e-05, \"p99_s\": 2e-05, "
                        "\"max_s\": 0.007"));
}

TEST(StatusJson, NobodyThere) {
  EXPECT_EQ(json(Snapshot{}), "{\"tick_master\": \"\", \"services\": []}\n");
}

}  // namespace
}  // namespace scarab::status
