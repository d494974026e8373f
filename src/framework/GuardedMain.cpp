#include "framework/GuardedMain.h"

#include <unistd.h>

#include <atomic>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <iterator>
#include <new>

#include "framework/CommandLine.h"
#include "framework/ConfigurationError.h"
#include "framework/CrashLog.h"
#include "framework/PartialFolder.h"
#include "framework/SingleLine.h"
#include "framework/StopSignal.h"

namespace plumbline {
namespace {

constexpr int badInput = ConfigurationError::exitCode, interrupted = 130;
const char* programName = "";
volatile std::sig_atomic_t memoryWasShort = 0;
std::atomic<bool> ending = false;

/// Without an allocation: none may be left.
void print(std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, part, std::strlen(part));
  }
}

void printError(const char* what) { print({programName, ": ", what, "\n"}); }

int fail(const std::exception& error, int status) noexcept {
  try {
    printError(errorLine(error).c_str());
  } catch (...) {
    printError(error.what());
  }
  return status;
}

/// Called by operator new where malloc gives nothing.
[[noreturn]] void noMemory() {
  memoryWasShort = 1;
  throw std::bad_alloc();
}

[[noreturn]] void endOutOfMemory() {
  if (!ending.exchange(true)) {  // removing may come here again, and a second thread ends it as a kill does
    printError("out of memory");
    CrashLog::giveUp();
    PartialFolder::removeAll();
  }
  _exit(badInput);
}

/// Ends the program if memory was short and an exception is on its way: libraries die of that otherwise.
/// libstdc++'s directory_iterator may not throw, and nlohmann's json asserts that what is destroyed was
/// whole.
void endForLackOfMemory() {
  if (memoryWasShort != 0 && std::uncaught_exceptions() > 0) endOutOfMemory();
}

void aborted(int) { endForLackOfMemory(); }

/// The end of what no catch reaches: a thread, a destructor.
[[noreturn]] void terminated() {
  if (const std::exception_ptr problem = std::current_exception()) {
    try {
      std::rethrow_exception(problem);
    } catch (const std::bad_alloc&) {
      endOutOfMemory();
    } catch (const std::exception& error) {
      printError(error.what());
    } catch (...) {
      printError("ended by an unknown exception");
    }
  }
  endForLackOfMemory();
  std::abort();  // which CrashLog sees
}

}  // namespace

/// What assert() calls, in place of glibc's, whose line would come before the program's own: assertions of
/// libraries fail, too, where memory was short.
// With glibc's own word for what does not return: clang takes no other one here.
// NOLINTNEXTLINE(bugprone-reserved-identifier,cert-dcl37-c,cert-dcl51-cpp,readability-identifier-naming)
extern "C" __attribute__((noreturn)) void __assert_fail(const char* assertion, const char* file,
                                                        unsigned line, const char* function) noexcept {
  endForLackOfMemory();
  char digits[16];
  *std::to_chars(digits, std::end(digits) - 1, line).ptr = '\0';
  print({programName, ": ", file, ":", digits, ": ", function != nullptr ? function : "", ": assertion '",
         assertion, "' failed\n"});
  std::abort();
}

int guardedMain(const char* program, int (*run)(int, char**), int argc, char** argv, int fault) noexcept {
  programName = program;
  std::set_terminate(terminated);
  std::set_new_handler(noMemory);
  std::signal(SIGABRT, aborted);  // abort() goes on to what it does without it
  int status = fault;
  try {
    status = run(argc, argv);
  } catch (const std::bad_alloc&) {
    printError("out of memory");
    status = badInput;
  } catch (const Stopped& stopped) {
    std::fflush(stdout);
    printError(stopped.what().c_str());
    status = interrupted;
  } catch (const ConfigurationError& error) {
    std::fflush(stdout);
    status = fail(error, badInput);
  } catch (const std::exception& error) {
    std::fflush(stdout);
    status = fail(error, fault);
  } catch (...) {
    printError("ended by an unknown exception");
  }
  try {
    return flushedStatus(program, status);
  } catch (...) {
    printError("out of memory");
    return badInput;
  }
}

}  // namespace plumbline
