#include "framework/GraphReport.h"

#include <gtest/gtest.h>

#include <thread>

#include "framework/AgentDebug.h"
#include "framework/Module.h"
#include "framework/TestModules.h"
#include "framework/Waiting.h"

namespace plumbline {

MODULE(ReportedReader)
  REQUIRES(Alpha)
  REQUIRES_IF_PROVIDED(Orphan)
  USES(Beta)
  PROVIDES(Gamma)
  PARAMETER(double, gain, 0.5, "1/s", Range(0, 2), "how fast it follows")
END_MODULE
class ReportedReader : public ReportedReaderBase {
public:
  void execute() override {
    const Waiting waiting;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  void update(Gamma* theGamma) override { theGamma->value = 1; }
};
MAKE_MODULE(ReportedReader)

namespace {

TEST(GraphReportTest, saysWhatModulesProvideReadAndTake) {
  Controller controller = makeController("[one 1]\nAlphaSource Alpha\nReportedReader Gamma\n");
  controller.runCycles(4);
  const auto threads = controller.debug().graph();
  ASSERT_EQ(threads.size(), 1u);
  EXPECT_EQ(threads[0].name, "one");
  EXPECT_EQ(threads[0].cycles, 4u);
  ASSERT_EQ(threads[0].modules.size(), 2u);
  const ModuleReport& source = threads[0].modules[0];
  EXPECT_EQ(source.name, "AlphaSource");
  EXPECT_EQ(source.provides, std::vector<std::string>{"Alpha"});
  EXPECT_GT(source.time, 0);
  EXPECT_EQ(source.wait, 0);
  const ModuleReport& reader = threads[0].modules[1];
  EXPECT_EQ(reader.reads, std::vector<std::string>{"Alpha"}) << "nobody provides Orphan";
  EXPECT_TRUE(reader.uses.empty());
  EXPECT_GE(reader.wait, 2000);
  EXPECT_LT(reader.time, reader.wait) << "waiting is no work";
}

TEST(GraphReportTest, namesWhatComesFromOtherThreads) {
  Controller controller =
      makeController("[one 1]\nAlphaSource Alpha\n[two 2]\none Alpha\nReportedReader Gamma\n");
  controller.init();
  const auto threads = controller.debug().graph();
  ASSERT_EQ(threads.size(), 2u);
  ASSERT_EQ(threads[1].copies.size(), 1u);
  EXPECT_EQ(threads[1].copies[0].thread, "one");
  EXPECT_EQ(threads[1].copies[0].representation, "Alpha");
}

TEST(GraphReportTest, parametersAreKnownWithTypeAndRange) {
  Controller controller = makeController("AlphaSource Alpha\nReportedReader Gamma\n");
  controller.init();
  const auto parameters = controller.debug().parameters();
  const auto found = parameters.find("config:ReportedReader.gain");
  ASSERT_NE(found, parameters.end());
  EXPECT_EQ(found->second.type, "double");
  EXPECT_EQ(found->second.parameter->unit, "1/s");
  EXPECT_EQ(found->second.parameter->range.max, 2);
}

}  // namespace
}  // namespace plumbline
