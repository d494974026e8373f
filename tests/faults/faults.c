// Makes system calls fail, for tests of what programs do then: cc -shared -fPIC -o faults.so faults.c -ldl,
// and
//
//     LD_PRELOAD=faults.so FAULT=write:3 FAULT_LOG=FILE FAULT_PROGRAM=gap bin/gap ...
//
// FAULT is KIND:N, the N-th call of the kind from the beginning of main on (1 the first). With a + behind:
// that one and all that follow, as on a disk that is full. With a ! behind: the program is killed there
// instead, after half of a write. With ^INT or ^TERM behind: it gets that signal there, as by Ctrl-C or kill,
// and goes on. Kinds:
//   write   to regular files, also by stdio                                    ENOSPC
//   sync    fsync, fdatasync of files and folders                              EIO
//   rename  and link                                                           EIO
//   open    of files for writing, and mkdir                                    ENOSPC
//   malloc  and what else allocates                                            ENOMEM
//   moment  no call but the N-th millisecond, for signals
// FAULT_LOG gets a line "KIND N" for a call that failed, and with FAULT=count at the end a line "KIND CALLS"
// for each kind. Of a signal: "sent MICROSECONDS" by the clock, "caught 1" where the program had a handler,
// and at the program's end "ended MICROSECONDS" and "cpu MICROSECONDS", what it computed since.
// FAULT_PROGRAM: only in the program of that name, not in those that it starts. FAULT_LEAVES_OUT: words with
// : between them; calls from libraries whose path has one of them neither count nor fail. FAULT_PLACES gets
// with FAULT=count a line "place N" for the first allocation from each place of the program. FAULT_PATIENCE:
// seconds until a program that hangs is ended by SIGALRM.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <execinfo.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/uio.h>
#include <time.h>
#include <unistd.h>

enum { WRITE, SYNC, RENAME, OPEN, MALLOC, MOMENT, KINDS };
static const char* const names[KINDS] = {"write", "sync", "rename", "open", "malloc", "moment"};
static const int errors[KINDS] = {ENOSPC, EIO, EIO, ENOSPC, ENOMEM, 0};

static atomic_int running;  // main has begun
static atomic_long calls[KINDS];
static int wanted = -1, lasting, killing, stopping, counting;
static pid_t process;        // not what it forks
static long begin, cpuThen;  // [us]
static long which;
static const char* logFile;

// Where memory is asked for: the innermost return addresses of a call, as one number. Each place is noted
// when it is first seen, so that all of them can be tried without trying each of a million calls.
enum { DEPTH = 5, PLACES = 1 << 16 };
static atomic_ulong places[PLACES];
static const char* placeFile;
static _Thread_local int looking;  // the first backtrace() allocates

// Whether a library that is left out makes this call, itself or by another one.
static const char* leftOut;
static int isLeftOut(void) {
  enum { DEEP = 48 };
  void* from[DEEP];
  looking = 1;
  const int count = backtrace(from, DEEP);
  int found = 0;
  for (int i = 0; i < count && !found; ++i) {
    Dl_info library;
    if (!dladdr(from[i], &library) || !library.dli_fname) continue;
    for (const char* word = leftOut; *word && !found;) {
      const size_t length = strcspn(word, ":");
      found = length > 0 && memmem(library.dli_fname, strlen(library.dli_fname), word, length) != NULL;
      word += length + (word[length] == ':');
    }
  }
  looking = 0;
  return found;
}

// By system calls alone: this runs within malloc.
static void noteIn(const char* file, const char* kind, long n) {
  if (!file) return;
  char line[64], digits[24];
  size_t length = strlen(kind);
  memcpy(line, kind, length);
  line[length++] = ' ';
  int count = 0;
  do digits[count++] = (char)('0' + n % 10);
  while ((n /= 10) > 0);
  while (count > 0) line[length++] = digits[--count];
  line[length++] = '\n';
  const long fd = syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (fd < 0) return;
  syscall(SYS_write, fd, line, length);
  syscall(SYS_close, fd);
}

// One kill, also where processes that a program makes of itself come to the same call.
static int isFirst(void) {
  if (!logFile) return 1;
  const long fd = syscall(SYS_openat, AT_FDCWD, logFile, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (fd >= 0) syscall(SYS_close, fd);
  return fd >= 0;
}
static void note(const char* kind, long n) { noteIn(logFile, kind, n); }

static void notePlace(long n) {
  looking = 1;
  void* from[DEPTH + 3];
  const int count = backtrace(from, DEPTH + 3);
  looking = 0;
  unsigned long place = 14695981039346656037ul;  // FNV-1a
  for (int i = 3; i < count; ++i) place = (place ^ (unsigned long)from[i]) * 1099511628211ul;
  for (unsigned long at = place, tried = 0; tried < 64; ++at, ++tried) {
    unsigned long is = 0;
    if (atomic_compare_exchange_strong(&places[at % PLACES], &is, place | 1)) {
      noteIn(placeFile, "place", n);
      return;
    }
    if (is == (place | 1)) return;
  }
}

static long microseconds(clockid_t clock) {
  struct timespec time;
  clock_gettime(clock, &time);
  return time.tv_sec * 1000000 + time.tv_nsec / 1000;
}

static void stop(void) {
  struct sigaction handler;
  sigaction(stopping, NULL, &handler);
  note("caught", handler.sa_handler != SIG_DFL);
  cpuThen = microseconds(CLOCK_PROCESS_CPUTIME_ID);
  note("sent", microseconds(CLOCK_REALTIME));
  kill(process, stopping);
}

static void* stopLater(void* unused) {
  sigset_t all;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, NULL);
  struct timespec rest = {which / 1000, which % 1000 * 1000000};
  while (nanosleep(&rest, &rest) != 0) continue;
  if (atomic_load(&running)) {
    note(names[MOMENT], which);
    stop();
  }
  return unused;
}

static int fails(int kind) {
  if (!atomic_load(&running) || looking || (leftOut && isLeftOut())) return 0;
  const long n = atomic_fetch_add(&calls[kind], 1) + 1;
  if (counting && kind == MALLOC && placeFile) notePlace(n);
  if (kind != wanted || (lasting ? n < which : n != which)) return 0;
  if (stopping && getpid() != process) return 0;
  if (killing && !isFirst()) return 0;
  if (n == which) note(names[kind], n);
  if (stopping) {
    stop();
    return 0;
  }
  if (killing && kind != WRITE) kill(getpid(), SIGKILL);
  errno = errors[kind];
  return 1;
}

// Half of a write, and the end.
static void writeHalf(int fd, const void* data, size_t size, off_t at) {
  if (!killing) return;
  if (at >= 0)
    syscall(SYS_pwrite64, fd, data, size / 2, at);
  else
    syscall(SYS_write, fd, data, size / 2);
  kill(getpid(), SIGKILL);
}

static int isFile(int fd) {
  struct stat status;
  return fd > 2 && fstat(fd, &status) == 0 &&
         S_ISREG(status.st_mode);  // what programs print is a test of its own
}

static void* next(const char* name) { return dlsym(RTLD_NEXT, name); }
int __libc_start_main(int (*start)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end);

#define REAL(name)               \
  static __typeof__(&name) real; \
  if (!real) real = (__typeof__(&name))next(#name)

ssize_t write(int fd, const void* data, size_t size) {
  REAL(write);
  if (!isFile(fd) || !fails(WRITE)) return real(fd, data, size);
  writeHalf(fd, data, size, -1);
  return -1;
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  REAL(pwrite);
  if (!isFile(fd) || !fails(WRITE)) return real(fd, data, size, at);
  writeHalf(fd, data, size, at);
  return -1;
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  REAL(pwrite64);
  if (!isFile(fd) || !fails(WRITE)) return real(fd, data, size, at);
  writeHalf(fd, data, size, at);
  return -1;
}
ssize_t writev(int fd, const struct iovec* parts, int count) {
  REAL(writev);
  if (!isFile(fd) || !fails(WRITE)) return real(fd, parts, count);
  writeHalf(fd, parts[0].iov_base, parts[0].iov_len, -1);
  return -1;
}
size_t fwrite(const void* data, size_t size, size_t count, FILE* file) {
  REAL(fwrite);
  if (file == stderr || file == stdout || !isFile(fileno(file)) || !fails(WRITE))
    return real(data, size, count, file);
  writeHalf(fileno(file), data, size * count, -1);
  return 0;
}
int fflush(FILE* file) {
  REAL(fflush);
  if (!file || file == stderr || file == stdout || !isFile(fileno(file)) || !fails(WRITE)) return real(file);
  writeHalf(fileno(file), "", 0, -1);
  return EOF;
}
int ftruncate(int fd, off_t size) {
  REAL(ftruncate);
  if (!fails(WRITE)) return real(fd, size);
  writeHalf(fd, "", 0, -1);
  return -1;
}

int fsync(int fd) {
  REAL(fsync);
  return fails(SYNC) ? -1 : real(fd);
}
int fdatasync(int fd) {
  REAL(fdatasync);
  return fails(SYNC) ? -1 : real(fd);
}

int rename(const char* from, const char* to) {
  REAL(rename);
  return fails(RENAME) ? -1 : real(from, to);
}
int renameat2(int fromFolder, const char* from, int toFolder, const char* to, unsigned flags) {
  REAL(renameat2);
  return fails(RENAME) ? -1 : real(fromFolder, from, toFolder, to, flags);
}
int link(const char* from, const char* to) {
  REAL(link);
  return fails(RENAME) ? -1 : real(from, to);
}

static int writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY || (flags & O_CREAT); }
static int special(const char* path) {
  return strncmp(path, "/dev/", 5) == 0 || strncmp(path, "/proc/", 6) == 0;
}
#define OPENS(name)                                                                       \
  int name(const char* path, int flags, ...) {                                            \
    REAL(name);                                                                           \
    va_list more;                                                                         \
    va_start(more, flags);                                                                \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(more, mode_t) : 0;       \
    va_end(more);                                                                         \
    return writes(flags) && !special(path) && fails(OPEN) ? -1 : real(path, flags, mode); \
  }
OPENS(open)
OPENS(open64)
FILE* fopen(const char* path, const char* mode) {
  REAL(fopen);
  return strpbrk(mode, "wa+") && !special(path) && fails(OPEN) ? NULL : real(path, mode);
}
FILE* fopen64(const char* path, const char* mode) {
  REAL(fopen64);
  return strpbrk(mode, "wa+") && !special(path) && fails(OPEN) ? NULL : real(path, mode);
}
int mkdir(const char* path, mode_t mode) {
  REAL(mkdir);
  return fails(OPEN) ? -1 : real(path, mode);
}

// glibc's own names: dlsym itself allocates.
extern void* __libc_malloc(size_t);
extern void* __libc_calloc(size_t, size_t);
extern void* __libc_realloc(void*, size_t);
extern void* __libc_memalign(size_t, size_t);
void* malloc(size_t size) { return fails(MALLOC) ? NULL : __libc_malloc(size); }
void* calloc(size_t count, size_t size) { return fails(MALLOC) ? NULL : __libc_calloc(count, size); }
void* realloc(void* old, size_t size) { return fails(MALLOC) ? NULL : __libc_realloc(old, size); }
void* memalign(size_t alignment, size_t size) {
  return fails(MALLOC) ? NULL : __libc_memalign(alignment, size);
}
void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }
int posix_memalign(void** result, size_t alignment, size_t size) {
  void* memory = memalign(alignment, size);
  if (memory) *result = memory;
  return memory ? 0 : ENOMEM;
}

static void tellCounts(void) {
  if (!atomic_exchange(&running, 0)) return;
  if (cpuThen && getpid() == process) {
    note("ended", microseconds(CLOCK_REALTIME));
    note("cpu", microseconds(CLOCK_PROCESS_CPUTIME_ID) - cpuThen);
  }
  if (!counting) return;
  atomic_store(&calls[MOMENT], (microseconds(CLOCK_MONOTONIC) - begin) / 1000);
  for (int kind = 0; kind < KINDS; ++kind) note(names[kind], atomic_load(&calls[kind]));
}
void _exit(int status) {
  tellCounts();
  syscall(SYS_exit_group, status);
  __builtin_unreachable();
}

static int (*realMain)(int, char**, char**);
static int countedMain(int argc, char** argv, char** environment) {
  const char* fault = getenv("FAULT");
  const char* program = getenv("FAULT_PROGRAM");
  logFile = getenv("FAULT_LOG");
  placeFile = getenv("FAULT_PLACES");
  leftOut = getenv("FAULT_LEAVES_OUT");
  const char* name = strrchr(argv[0], '/');
  name = name ? name + 1 : argv[0];
  if (fault && (!program || strcmp(program, name) == 0)) {
    const char* patience = getenv("FAULT_PATIENCE");
    if (patience) alarm((unsigned)atoi(patience));  // what hangs ends by this signal
    counting = strcmp(fault, "count") == 0;
    for (int kind = 0; kind < KINDS; ++kind) {
      const size_t length = strlen(names[kind]);
      if (strncmp(fault, names[kind], length) != 0 || fault[length] != ':') continue;
      wanted = kind;
      char* end;
      which = strtol(fault + length + 1, &end, 10);
      lasting = *end == '+';
      killing = *end == '!';
      if (*end == '^') stopping = strcmp(end + 1, "INT") == 0 ? SIGINT : SIGTERM;
    }
    process = getpid();
    begin = microseconds(CLOCK_MONOTONIC);
    if (counting || stopping) atexit(tellCounts);
    pthread_t thread;
    if (wanted == MOMENT && pthread_create(&thread, NULL, stopLater, NULL) != 0) return 99;
    atomic_store(&running, 1);
  }
  return realMain(argc, argv, environment);
}
int __libc_start_main(int (*start)(int, char**, char**), int argc, char** argv, void (*init)(void),
                      void (*fini)(void), void (*rtld_fini)(void), void* stack_end) {
  REAL(__libc_start_main);
  realMain = start;
  return real(countedMain, argc, argv, init, fini, rtld_fini, stack_end);
}
