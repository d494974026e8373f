#pragma once
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "support/FarOff.h"

namespace plumbline::test {

/// A program `dot` that comes before Graphviz's: a shell script in a folder of its own.
class OtherDot {
public:
  OtherDot(std::string folder, const std::string& script)
      : folder_(std::move(folder)), path_(std::getenv("PATH")) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ + "/dot") << "#!/bin/sh\necho $$ > '" << folder_ << "/new' && mv '" << folder_
                                    << "/new' '" << folder_ << "/pid'\n"
                                    << script << '\n';
    std::filesystem::permissions(folder_ + "/dot", std::filesystem::perms::owner_all);
    setenv("PATH", (folder_ + ":" + path_).c_str(), 1);
  }
  ~OtherDot() {
    setenv("PATH", path_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }
  OtherDot(const OtherDot&) = delete;
  OtherDot& operator=(const OtherDot&) = delete;

  /// Its number once it runs; 0: it never does.
  pid_t waitUntilItRuns() const {
    pid_t pid = 0;
    comesTrue([&] { return bool(std::ifstream(folder_ + "/pid") >> pid); });
    return pid;
  }

private:
  std::string folder_, path_;
};

}  // namespace plumbline::test
