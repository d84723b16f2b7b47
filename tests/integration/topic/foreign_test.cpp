// Topics of programs that know nothing of this project.
#include "tests/integration/topic/topic_tool.hpp"
#include "tests/integration/types/sample_filler.hpp"
#include "tests/ros_idl/ros_types.hpp"

namespace scarab::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

using Foreign = TopicTool;

TEST_F(Foreign, EveryCommonTypeOfRosIsEchoed) {
  std::vector<std::unique_ptr<AnyWriter>> writers;
  std::vector<std::unique_ptr<FilledSample>> samples;
  for (const auto* type : ros_types()) {
    samples.push_back(std::make_unique<FilledSample>(*type));
    writers.push_back(
        std::make_unique<AnyWriter>(plant_, "rt/" + std::to_string(samples.size()), *type));
    writers.back()->write(samples.back()->get());
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Finished echo =
        topic({"echo", "rt/" + std::to_string(i + 1), "--once", "--json", "--timeout", "20"});
    EXPECT_EQ(echo.out, samples[i]->json() + "\n")
        << ros_types()[i]->m_typename << " " << echo.exit_code << " " << echo.err;
  }
}

TEST_F(Foreign, AWriterWithoutTypeInformationIsReadAsOurOwn) {
  bus::RawWriter writer(plant_, "scarab/operator",
                        disguised(bus::descriptor<scarab_Operator>(), "scarab::Operator", false),
                        kept());
  scarab_Operator sample{};
  sample.mode = scarab_MODE_BOXING;
  writer.write(bus::encode(sample));
  const Finished echo = topic({"echo", "scarab/operator", "--once", "--field", "mode"});
  EXPECT_EQ(echo.exit_code, 0) << echo.err;
  EXPECT_EQ(echo.out, "MODE_BOXING\n");
}

TEST_F(Foreign, DdsperfIsListedEchoedAndMeasured) {
  const auto uri =
      "CYCLONEDDS_URI=<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface "
      "name=\"lo\" multicast=\"true\"/></Interfaces></General><Discovery><Tag>" +
      test_tag() + "</Tag></Discovery></Domain></CycloneDDS>";
  ChildProcess ddsperf({"/usr/bin/env", uri, "ddsperf", "pub", "200Hz", "size", "40"},
                       directory_ / "ddsperf");
  const Finished wait = topic({"wait", "DDSPerfRDataKS", "--hz", "150", "--timeout", "20"});
  ASSERT_EQ(wait.exit_code, 0) << wait.err << ddsperf.output();
  EXPECT_THAT(topic({"list"}).out,
              AllOf(HasSubstr("DDSPerfRDataKS   KeyedSeq  ddsperf["), HasSubstr("CPUStats")));
  const Finished echo = topic({"echo", "DDSPerfRDataKS", "-n", "2", "--csv", "--field", "keyval",
                               "--field", "baggage[0]", "--filter", "baggage.length > 0"});
  EXPECT_EQ(echo.exit_code, 0) << echo.err;
  EXPECT_EQ(echo.out, "keyval,baggage[0]\n0,238\n0,238\n");
  EXPECT_THAT(topic({"type", "DDSPerfRDataKS"}).out, HasSubstr("sequence<octet> baggage;"));
  EXPECT_THAT(topic({"bw", "DDSPerfRDataKS", "-n", "1", "--json"}).out,
              HasSubstr("\"size_min_bytes\": 44"));
  EXPECT_THAT(topic({"ps"}).out, HasSubstr("ddsperf"));
}

}  // namespace
}  // namespace scarab::test
