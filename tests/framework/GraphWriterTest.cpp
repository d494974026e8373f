#include "framework/GraphWriter.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "framework/ConfigurationError.h"
#include "framework/StopSignal.h"
#include "framework/TestModules.h"
#include "support/OtherDot.h"

namespace plumbline {
namespace {

std::vector<ThreadPlan> twoThreads() {
  return planThreads(parseModulesConfig(
      "[a 2]\nAlphaFromLastGamma Alpha\nBetaFromAlpha Beta\n[b 1]\na Alpha\nOptionalReader\n",
      "modules.cfg"));
}

std::string contents(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A folder of its own, removed at the end.
class GraphWriterTest : public testing::Test {
protected:
  GraphWriterTest() { std::filesystem::create_directories(folder); }
  ~GraphWriterTest() override { std::filesystem::remove_all(folder); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
  }
  std::string errorOf(const std::string& path) const {
    try {
      writeGraph(twoThreads(), path);
    } catch (const ConfigurationError& error) {
      return error.what();
    }
    return "no error";
  }
  const std::string folder = testing::TempDir() + "/graph" + std::to_string(getpid());
};

TEST_F(GraphWriterTest, drawsModulesRepresentationsAndThreads) {
  writeGraph(twoThreads(), folder + "/graph.dot");
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(contents(folder + "/graph.dot"),
            R"(digraph modules {
  node [fontname="Helvetica"];
  graph [fontname="Helvetica", rankdir=LR, ranksep=0.4, nodesep=0.12];
  labelloc=b;
  label="box: module    ellipse: representation    full line: REQUIRES, PROVIDES    grey: REQUIRES_IF_PROVIDED    dashed: USES    dotted: copy between threads";
  subgraph "cluster_a" {
    label="a";
    "a/module/AlphaFromLastGamma" [label="AlphaFromLastGamma", shape=box];
    "a/representation/Alpha" [label="Alpha", shape=ellipse];
    "a/module/BetaFromAlpha" [label="BetaFromAlpha", shape=box];
    "a/representation/Beta" [label="Beta", shape=ellipse];
    "a/module/AlphaFromLastGamma" -> "a/representation/Alpha";
    "a/module/BetaFromAlpha" -> "a/representation/Beta";
    "a/representation/Alpha" -> "a/module/BetaFromAlpha";
  }
  subgraph "cluster_b" {
    label="b";
    "b/representation/Alpha" [label="Alpha", shape=ellipse];
    "b/module/OptionalReader" [label="OptionalReader", shape=box];
    "b/representation/Alpha" -> "b/module/OptionalReader" [color=gray50];
  }
  "a/representation/Alpha" -> "b/representation/Alpha" [style=dotted];
}
)");
}

TEST_F(GraphWriterTest, timesStandInTheModules) {
  const std::string text = graphText(twoThreads(), {{"BetaFromAlpha", 12.34}});
  EXPECT_NE(text.find(R"([label="BetaFromAlpha\n12.3 us", shape=box])"), std::string::npos);
  EXPECT_NE(text.find(R"([label="AlphaFromLastGamma", shape=box])"), std::string::npos);
  EXPECT_NE(text.find("copy between threads    us: mean time in a cycle, waiting included\";\n"),
            std::string::npos);
}

TEST_F(GraphWriterTest, anAreaIsTheFolderOfAModule) {
  EXPECT_EQ(ModuleDescription("A", "src/modules/perception/ball/A.h").area(), "perception");
  EXPECT_EQ(ModuleDescription("A", "modules/A.h").area(), "");
  EXPECT_EQ(ModuleDescription("A", "tests/framework/TestModules.h").area(), "");
}

TEST_F(GraphWriterTest, anAreaIsAFrameOfItsOwnColour) {
  std::vector<ThreadPlan> threads = twoThreads();
  ModuleDescription& description =
      const_cast<ModuleDescription&>(threads[0].modules[1].loader->description());
  description.file = "src/modules/modeling/B.h";
  const std::string text = graphText(threads);
  description.file.clear();
  EXPECT_NE(text.find(R"(    subgraph "cluster_a/modeling" {
    label="modeling"; labelloc=t; fontsize=24; style="filled,rounded"; color="#d9ead3";
    "a/module/BetaFromAlpha" [label="BetaFromAlpha", shape=box, style=filled, fillcolor=white];
    "a/representation/Beta" [label="Beta", shape=ellipse];
    }
)"),
            std::string::npos)
      << text;
}

TEST_F(GraphWriterTest, drawsPicturesThroughGraphviz) {
  if (std::system("dot -V > /dev/null 2>&1") != 0) GTEST_SKIP() << "Graphviz is not installed";
  writeGraph(twoThreads(), folder + "/graph.svg");
  EXPECT_NE(contents(folder + "/graph.svg").find("AlphaFromLastGamma</text>"), std::string::npos);
  writeGraph(twoThreads(), folder + "/graph.png");
  EXPECT_EQ(contents(folder + "/graph.png").substr(1, 3), "PNG");
  EXPECT_EQ(files(), 2u);
}

TEST_F(GraphWriterTest, aSignalThatEndsTheDrawingLeavesNothing) {
  const test::OtherDot dot(folder + "-bin", "exec sleep 1000");
  StopSignal stop;
  stop.catchSignals();
  std::thread person([&] {
    dot.waitUntilItRuns();
    kill(getpid(), SIGINT);
  });
  EXPECT_THROW(writeGraph(twoThreads(), folder + "/graph.svg"), Stopped);
  person.join();
  EXPECT_EQ(files(), 0u);
}

TEST_F(GraphWriterTest, saysWhatCannotBeWrittenAndLeavesNothing) {
  EXPECT_EQ(errorOf(folder + "/graph.txt"),
            folder + "/graph.txt: a graph is written as .dot, .svg, .pdf or .png");
  EXPECT_EQ(errorOf(folder + "/graph"), folder + "/graph: a graph is written as .dot, .svg, .pdf or .png");
  EXPECT_EQ(errorOf(folder + "/missing/graph.dot"),
            folder + "/missing/graph.dot: cannot be written: No such file or directory");
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  EXPECT_EQ(errorOf(folder + "/graph.svg"),
            folder +
                "/graph.svg: cannot be written: Graphviz's program dot is not installed; install graphviz or "
                "write a .dot file");
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(files(), 0u);
}

}  // namespace
}  // namespace plumbline
