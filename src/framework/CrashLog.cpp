#include "framework/CrashLog.h"

#include <execinfo.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>

#include "framework/CrashReport.h"
#include "framework/Log.h"
#include "framework/LogBuffer.h"
#include "framework/ThreadObject.h"

namespace plumbline {
namespace {

constexpr std::array caughtSignals = {SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGABRT,
                                      SIGSYS,  SIGTRAP, SIGQUIT, SIGXCPU, SIGPIPE};

// What the signal handler needs; set before it is installed.
CrashRecord* record = nullptr;
int pipeToWriter = -1;
pid_t writer = -1;
unsigned deadline = 30;       ///< [s]
std::atomic<pid_t> dying{0};  ///< the thread that was struck
char note[512];
std::array<struct sigaction, caughtSignals.size()> previous;

void say(const char* text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

/// Waits for the writer, but not for ever: it might hang on a full disk. False: it is still there.
bool waitForWriter() {
  for (int i = 0; i < 3000; ++i) {
    if (waitpid(writer, nullptr, WNOHANG) != 0) return true;
    const timespec millisecond{0, 1000000};
    nanosleep(&millisecond, nullptr);
  }
  return false;
}

/// Ends the process by the signal, which nobody catches any more.
[[noreturn]] void dieBy(int signal) {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, signal);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  raise(signal);
  _exit(128 + signal);
}

/// The last word, after `deadline`. Says nothing: a full pipe may be what everything hangs on.
void dieNow(int) { dieBy(record->signal); }

void startDeadline() {
  struct sigaction action {};
  action.sa_handler = dieNow;
  sigemptyset(&action.sa_mask);
  sigaction(SIGALRM, &action, nullptr);
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGALRM);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
  alarm(deadline);
}

/// Faults of an instruction, which strikes again when the handler returns.
bool strikesAgain(int signal, const siginfo_t& info) {
  const bool fault = signal == SIGSEGV || signal == SIGBUS || signal == SIGFPE || signal == SIGILL;
  return fault && info.si_code > 0;
}

// Only what a signal handler may do (and backtrace, which was called once before to load what it needs).
void handle(int signal, siginfo_t* info, void*) {
  int none = 0;
  if (!record->signal.compare_exchange_strong(none, signal)) {
    if (dying == gettid()) dieBy(signal);  // struck again while it was being written about
    // Another thread died first.
    while (true) pause();
  }
  dying = gettid();
  startDeadline();
  record->signalThread = CrashRecord::currentThread();
  record->callCount = backtrace(record->calls.data(), static_cast<int>(record->calls.size()));
  // The writer first: the reader of standard error may be stuck.
  const char byte = 1;
  [[maybe_unused]] const auto written = ::write(pipeToWriter, &byte, 1);
  say("died by ");
  say(signalName(signal));
  if (const char* step = record->stepOf(CrashRecord::currentThread())) {
    say(" in ");
    say(step);
  }
  say(note);
  waitForWriter();
  for (std::size_t i = 0; i < caughtSignals.size(); ++i) {
    if (caughtSignals[i] == signal) sigaction(signal, &previous[i], nullptr);
  }
  // A fault strikes again on return, then at the right place for a debugger or sanitizer; any other signal
  // has to be sent again.
  if (!strikesAgain(signal, *info)) raise(signal);
}

/// A descriptor of the process that has started this one, if its death kills this one; else -1.
int starterWhoTakesItAlong() {
  int signal = 0;
  if (prctl(PR_GET_PDEATHSIG, &signal) != 0 || signal != SIGKILL) return -1;
  return static_cast<int>(syscall(SYS_pidfd_open, getppid(), 0));
}

/// Linux kills who is taken along microseconds before it shows the end. Who kills a child that hangs may end
/// soon after, which is another matter: so there is no long wait.
bool hasEnded(int process) {
  pollfd one{process, POLLIN, 0};
  return poll(&one, 1, 2) > 0;
}

/// The second process. Waits for a byte (a signal was caught) or the end of the pipe (the agent is gone).
/// `starter`: as of starterWhoTakesItAlong().
[[noreturn]] void writerMain(int pipe, int starter, pid_t agent, const std::string& path) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE}) std::signal(signal, SIG_IGN);
  prctl(PR_SET_NAME, "crashlog");
  constexpr int pipePlace = STDERR_FILENO + 1, starterPlace = pipePlace + 1;
  pipe = fcntl(pipe, F_DUPFD, starterPlace + 1);
  starter = fcntl(starter, F_DUPFD, starterPlace + 1);
  const int null = open("/dev/null", O_RDWR);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(null, descriptor);
  // What the agent has open must not stay open because of this process.
  dup2(pipe, pipePlace);
  const bool takenAlong = starter >= 0 && dup2(starter, starterPlace) >= 0;
  close_range(takenAlong ? starterPlace + 1 : starterPlace, ~0u, 0);
  char byte = 0;
  while (read(pipePlace, &byte, 1) < 0 && errno == EINTR) {
  }
  if (!record->finished && !(record->signal == 0 && takenAlong && hasEnded(starterPlace)))
    writeCrashReport(*record, agent, path);
  _exit(0);
}

/// Null, or what was not possible.
const char* startWriter(const std::string& path) {
  // Stays mapped to the end of the program: threads may log at any time.
  void* memory =
      mmap(nullptr, sizeof(CrashRecord), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) return "no shared memory";
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return "no pipe";
  record = new (memory) CrashRecord;
  const pid_t agent = getpid();
  const int starter = starterWhoTakesItAlong();
  writer = fork();
  if (writer == 0) {
    close(ends[1]);
    writerMain(ends[0], starter, agent, path);
  }
  close(ends[0]);
  if (starter >= 0) close(starter);
  if (writer < 0) {
    close(ends[1]);
    return "no second process";
  }
  pipeToWriter = ends[1];
  return nullptr;
}

void markFinished() {
  if (record) record->finished = true;
}

/// A signal handler needs a stack of its own if the thread's stack is what broke.
class SignalStack {
public:
  SignalStack() : memory_(std::make_unique<char[]>(size)) {
    stack_t stack{};
    stack.ss_sp = memory_.get();
    stack.ss_size = size;
    active_ = sigaltstack(&stack, nullptr) == 0;
  }
  ~SignalStack() {
    stack_t stack{};
    stack.ss_flags = SS_DISABLE;
    if (active_) sigaltstack(&stack, nullptr);
  }

private:
  static constexpr std::size_t size = 64 * 1024;
  std::unique_ptr<char[]> memory_;
  bool active_ = false;
};

}  // namespace

void CrashLog::protectThread() {
  static ThreadObject<SignalStack> stacks;
  if (record) stacks.get();
}

void CrashLog::giveUp() noexcept { markFinished(); }

CrashLog::CrashLog(const std::string& path, unsigned secondsToDie)
    : path_(std::filesystem::absolute(path).string()) {
  deadline = secondsToDie;
  if (const char* failed = startWriter(path_)) {
    Log("framework").warning() << "no " << path << " will be written: " << failed << ": "
                               << std::strerror(errno);
    return;
  }
  LogBuffer::instance().useRecord(record);
  std::snprintf(note, sizeof(note), "; see %s\n", path.c_str());
  protectThread();
  void* first[1];
  backtrace(first, 1);
  // exit() somewhere is an end in order as well.
  static const int registered = std::atexit(markFinished);
  static_cast<void>(registered);
  struct sigaction action {};
  action.sa_sigaction = handle;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < caughtSignals.size(); ++i) {
    sigaction(caughtSignals[i], &action, &previous[i]);
    // Who started the agent may have chosen to ignore a signal: then it is no death.
    if (previous[i].sa_handler == SIG_IGN) sigaction(caughtSignals[i], &previous[i], nullptr);
  }
}

CrashLog::~CrashLog() {
  if (pipeToWriter < 0) return;
  for (std::size_t i = 0; i < caughtSignals.size(); ++i) sigaction(caughtSignals[i], &previous[i], nullptr);
  markFinished();
  close(pipeToWriter);
  pipeToWriter = -1;
  if (!waitForWriter()) {
    kill(writer, SIGKILL);
    waitpid(writer, nullptr, 0);
  }
  writer = -1;
}

}  // namespace plumbline
