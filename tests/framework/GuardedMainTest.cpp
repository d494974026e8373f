#include "framework/GuardedMain.h"

#include <gtest/gtest.h>

#include <cassert>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <thread>

#include "framework/ConfigurationError.h"
#include "framework/PartialFolder.h"
#include "framework/StopSignal.h"

namespace plumbline {
namespace {

int endsWell(int argc, char**) { return argc; }
int refuses(int, char**) { throw ConfigurationError("file:3: what\nis wrong"); }
int breaks(int, char**) { throw std::runtime_error("the server went away"); }
int cannotWrite(int, char**) {
  throw std::filesystem::filesystem_error("cannot rename", "runs.part", "runs",
                                          std::make_error_code(std::errc::no_space_on_device));
}
int isStopped(int, char**) { throw Stopped("stopped; nothing was written"); }
int lacksMemory(int, char**) { throw std::bad_alloc(); }
int throwsAnything(int, char**) { throw 3; }
int lacksMemoryInAThread(int, char**) {
  std::thread([] { throw std::bad_alloc(); }).join();
  return 0;
}
/// As operator new does where malloc gives nothing; the sanitizers' ends the program instead.
[[noreturn]] void allocateInVain() {
  std::get_new_handler()();
  std::abort();
}
void mayNotThrow() noexcept { allocateInVain(); }
int lacksMemoryWhereNothingMayThrow(int, char**) {
  mayNotThrow();
  return 0;
}
std::filesystem::path partialFolder() {
  return std::filesystem::path(testing::TempDir()) / "guardedMain.part";
}
int lacksMemoryWhileItWritesAFolder(int, char**) {
  const PartialFolder folder(partialFolder());
  std::filesystem::create_directories(folder.path() / "inner");
  mayNotThrow();
  return 0;
}
/// As nlohmann's json does when one is destroyed that was never whole.
struct AbortsWhenDestroyed {
  ~AbortsWhenDestroyed() { std::abort(); }
};
int lacksMemoryAndAborts(int, char**) {
  const AbortsWhenDestroyed object;
  allocateInVain();
}
struct AssertsWhenDestroyed {
  ~AssertsWhenDestroyed() { assert(std::uncaught_exceptions() < 0); }
};
int lacksMemoryAndAsserts(int, char**) {
  const AssertsWhenDestroyed object;
  allocateInVain();
}
int asserts(int, char**) {
  const AssertsWhenDestroyed object;
  return 0;
}
int abortsLater(int, char**) {
  try {
    allocateInVain();
  } catch (const std::bad_alloc&) {
  }
  std::abort();
}
int breaksInAThread(int, char**) {
  std::thread([] { throw std::runtime_error("a thread's matter"); }).join();
  return 0;
}

/// Of a process of its own, which begins anew: threads may run in this one.
void expectEnd(int (*run)(int, char**), int status, const std::string& line, int fault = 2) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(std::exit(guardedMain("prog", run, 0, nullptr, fault)), testing::ExitedWithCode(status),
              line.empty() ? "^$" : "^prog: " + line + "\n$");
}

TEST(GuardedMain, passesTheStatusOn) {
  EXPECT_EQ(guardedMain("prog", endsWell, 0, nullptr), 0);
  EXPECT_EQ(guardedMain("prog", endsWell, 5, nullptr), 5);
}

TEST(GuardedMainDeathTest, saysWhatWentWrongInOneLine) {
  expectEnd(refuses, 2, "file:3: what is wrong", 1);
  expectEnd(breaks, 2, "the server went away");
  expectEnd(breaks, 1, "the server went away", 1);
  expectEnd(cannotWrite, 2, "runs.part: No space left on device");
  expectEnd(isStopped, 130, "stopped; nothing was written");
  expectEnd(throwsAnything, 2, "ended by an unknown exception");
}

TEST(GuardedMainDeathTest, saysThatThereIsNoMemoryLeft) {
  expectEnd(lacksMemory, 2, "out of memory", 1);
  expectEnd(lacksMemoryInAThread, 2, "out of memory", 1);
}

TEST(GuardedMainDeathTest, lackOfMemoryIsSaidWhereItCannotBeCaught) {
  expectEnd(lacksMemoryWhereNothingMayThrow, 2, "out of memory", 1);
  expectEnd(lacksMemoryAndAborts, 2, "out of memory", 1);
}

TEST(GuardedMainDeathTest, aFolderThatWasBeingWrittenGoesWithoutItsDestructor) {
  std::filesystem::remove_all(partialFolder());
  expectEnd(lacksMemoryWhileItWritesAFolder, 2, "out of memory", 1);
  EXPECT_FALSE(std::filesystem::exists(partialFolder()));
}

TEST(GuardedMainDeathTest, anAssertionThatFailsForLackOfMemorySaysNothingOfItsOwn) {
  expectEnd(lacksMemoryAndAsserts, 2, "out of memory", 1);
}

TEST(GuardedMainDeathTest, anAssertionIsOneLineOfTheProgram) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(
      guardedMain("prog", asserts, 0, nullptr), testing::KilledBySignal(SIGABRT),
      "^prog: [^ ]*GuardedMainTest.cpp:[0-9]+: .*assertion 'std::uncaught_exceptions\\(\\) < 0' failed\n$");
}

TEST(GuardedMainDeathTest, whatAbortsForAnotherReasonDiesOfIt) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(guardedMain("prog", abortsLater, 0, nullptr), testing::KilledBySignal(SIGABRT), "^$");
}

TEST(GuardedMainDeathTest, aThreadsExceptionIsNamedBeforeTheProgramDies) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";
  EXPECT_EXIT(guardedMain("prog", breaksInAThread, 0, nullptr), testing::KilledBySignal(SIGABRT),
              "prog: a thread's matter");
}

}  // namespace
}  // namespace plumbline
