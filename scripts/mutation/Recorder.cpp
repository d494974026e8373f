// Goes into each test program of the copy of the tree that scripts/mutation.sh builds: notes which switched
// places a test reaches. PLUMBLINE_RECORD names the file: a line for what ran before the first test, then one
// for each test with its milliseconds and the numbers of the changes, tabs between.
#include "Switches.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace {
class Recorder : public testing::EmptyTestEventListener {
public:
  explicit Recorder(const char* path) : path_(path) {}

private:
  void OnTestProgramStart(const testing::UnitTest&) override { note("@start", 0); }
  void OnTestEnd(const testing::TestInfo& test) override {
    note(std::string(test.test_suite_name()) + "." + test.name(),
         static_cast<long>(test.result()->elapsed_time()));
  }

  void note(const std::string& name, long milliseconds) {
    std::ofstream file(path_, std::ios::app);
    file << name << '\t' << milliseconds;
    for (int number = 0; number < mutation::mostChanges; ++number) {
      if (mutation::ran[number]) file << '\t' << number;
      mutation::ran[number] = false;
    }
    file << '\n';
  }

  std::string path_;
};

const bool listens = [] {
  if (const char* path = std::getenv("PLUMBLINE_RECORD"))
    testing::UnitTest::GetInstance()->listeners().Append(new Recorder(path));
  return true;
}();
}  // namespace
