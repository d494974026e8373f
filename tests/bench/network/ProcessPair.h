#pragma once
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <new>
#include <stdexcept>
#include <string>

#include "framework/SteadyClock.h"

namespace plumbline::bench {

/// What two processes of a measurement share.
struct Shared {
  static constexpr int most = 5000;
  std::atomic<int> count{0};
  double values[most];
  void add(double value) {
    const int n = count;
    if (n >= most) return;
    values[n] = value;
    count = n + 1;
  }
};

/// This program once more, with another part to play, until it is killed. A process that was forked alone
/// would have what Fast DDS remembers of its parent.
class Child {
public:
  Child(const std::string& part, int memory) : pid_(fork()) {
    if (pid_ < 0) throw std::runtime_error("no process is left");
    if (pid_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    execl("/proc/self/exe", "network", part.c_str(), std::to_string(memory).c_str(), nullptr);
    _exit(1);
  }
  ~Child() { kill(); }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  void kill() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = 0;
  }

private:
  pid_t pid_;
};

/// Memory that a child shares with who made it.
class SharedMemory {
public:
  SharedMemory() : descriptor_(memfd_create("network", 0)) {
    if (descriptor_ < 0 || ftruncate(descriptor_, sizeof(Shared)) != 0)
      throw std::runtime_error("no memory to share");
    shared_ = new (map(descriptor_)) Shared;
  }
  ~SharedMemory() {
    munmap(shared_, sizeof(Shared));
    close(descriptor_);
  }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;
  Shared* operator->() { return shared_; }
  Shared& operator*() { return *shared_; }
  int descriptor() const { return descriptor_; }

  static void* map(int descriptor) {
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) throw std::runtime_error("no memory to share");
    return memory;
  }

private:
  int descriptor_;
  Shared* shared_ = nullptr;
};

}  // namespace plumbline::bench
