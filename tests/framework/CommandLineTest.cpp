#include "framework/CommandLine.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace plumbline {
namespace {

struct TypedLine {
  std::optional<int> status;
  std::string out, err;
};

TypedLine read(CommandLine& app, std::vector<const char*> words) {
  words.insert(words.begin(), "bin/prog");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  TypedLine line;
  line.status = readCommandLine(app, static_cast<int>(words.size()), words.data());
  line.out = testing::internal::GetCapturedStdout();
  line.err = testing::internal::GetCapturedStderr();
  return line;
}

struct Program {
  CommandLine app{"What it does."};
  int jobs = 0;
  bool bouncing = true;
  Program() {
    app.option("--jobs", jobs, "Threads").range(1, 4);
    app.flag("--bouncing-stops,!--no-bouncing-stops", bouncing, "Stops bounce");
  }
};

struct Commands {
  CommandLine app{"What it does."};
  std::string runs;
  int jobs = 0;
  Commands() {
    app.requireCommand();
    CommandLine diagnose = app.command("diagnose", "Diagnoses");
    diagnose.option("runs", runs, "Runs").required();
    diagnose.option("--jobs", jobs, "Threads");
    app.command("record", "Records");
  }
};

TEST(CommandLine, goesOnAfterAGoodLine) {
  Program program;
  const TypedLine line = read(program.app, {"--jobs", "3", "--no-bouncing-stops"});
  EXPECT_FALSE(line.status);
  EXPECT_EQ(program.jobs, 3);
  EXPECT_FALSE(program.bouncing);
  EXPECT_EQ(line.out + line.err, "");
}

TEST(CommandLine, printsTheVersion) {
  Program program;
  const TypedLine line = read(program.app, {"--version"});
  EXPECT_EQ(line.status, 0);
  EXPECT_EQ(line.out, "prog (" + versionText() + ")\n");
}

TEST(CommandLine, helpNamesFlagsThatSwitchOffPlainly) {
  Program program;
  const TypedLine line = read(program.app, {"--help"});
  EXPECT_EQ(line.status, 0);
  EXPECT_NE(line.out.find("--bouncing-stops,--no-bouncing-stops\n"), std::string::npos) << line.out;
  EXPECT_EQ(line.out.find("{false}"), std::string::npos) << line.out;
  EXPECT_NE(line.out.find("--version"), std::string::npos) << line.out;
}

TEST(CommandLine, namesTheNearestOption) {
  Program program;
  const TypedLine line = read(program.app, {"--jbos", "3"});
  EXPECT_EQ(line.status, 2);
  EXPECT_EQ(line.err, "prog: there is no option --jbos; did you mean \"--jobs\"?; see prog --help\n");
  Program other;
  EXPECT_EQ(read(other.app, {"--jbos=3"}).err,
            "prog: there is no option --jbos; did you mean \"--jobs\"?; see prog --help\n");
}

TEST(CommandLine, saysWhereNothingIsNear) {
  Program program;
  EXPECT_EQ(read(program.app, {"--xyzzy"}).err, "prog: there is no option --xyzzy; see prog --help\n");
  Program other;
  EXPECT_EQ(read(other.app, {"word"}).err, "prog: unexpected argument \"word\"; see prog --help\n");
}

TEST(CommandLine, saysWhichValueIsWrong) {
  Program program;
  const TypedLine line = read(program.app, {"--jobs", "9"});
  EXPECT_EQ(line.status, 2);
  EXPECT_EQ(line.err, "prog: --jobs: Value 9 not in range 1 to 4; see prog --help\n");
}

TEST(CommandLine, saysThatAValueIsMissingOrTooMany) {
  Program program;
  EXPECT_EQ(read(program.app, {"--jobs"}).err, "prog: --jobs takes one value, once; see prog --help\n");
  Program other;
  EXPECT_EQ(read(other.app, {"--jobs", "1", "--jobs", "2"}).err,
            "prog: --jobs takes one value, once; see prog --help\n");
}

TEST(CommandLine, namesTheNearestCommand) {
  Commands program;
  const TypedLine line = read(program.app, {"diagnos", "runs"});
  EXPECT_EQ(line.status, 2);
  EXPECT_EQ(line.err, "prog: there is no command diagnos; did you mean \"diagnose\"?; see prog --help\n");
}

TEST(CommandLine, namesTheNearestOptionOfACommand) {
  Commands program;
  EXPECT_EQ(read(program.app, {"diagnose", "--jbos", "2", "runs"}).err,
            "prog: there is no option --jbos; did you mean \"--jobs\"?; see prog diagnose --help\n");
  Commands without;
  EXPECT_EQ(read(without.app, {"--foo"}).err, "prog: there is no option --foo; see prog --help\n");
}

TEST(CommandLine, aMissingArgumentIsNamed) {
  Commands program;
  EXPECT_EQ(read(program.app, {"diagnose"}).err, "prog: runs is required; see prog diagnose --help\n");
}

TEST(CommandLine, saysWhenStandardOutputIsFull) {
  std::fflush(stdout);
  const int kept = dup(STDOUT_FILENO);
  ASSERT_NE(freopen("/dev/full", "w", stdout), nullptr);
  std::printf("lost\n");
  testing::internal::CaptureStderr();
  const int status = flushedStatus("prog", 0);
  const std::string err = testing::internal::GetCapturedStderr();
  dup2(kept, STDOUT_FILENO);
  close(kept);
  std::clearerr(stdout);
  EXPECT_EQ(status, 2);
  EXPECT_EQ(err, "prog: cannot write to standard output: No space left on device\n");
}

}  // namespace
}  // namespace plumbline
