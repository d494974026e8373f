#pragma once
#include <string>
#include <vector>

#include "framework/LogBuffer.h"

namespace plumbline::test {

/// What modules write into their logs while this lives.
class LogLines {
public:
  LogLines() {
    LogBuffer::instance().setListener(
        [this](std::string_view, std::string_view message) { lines.emplace_back(message); });
  }
  ~LogLines() { LogBuffer::instance().setListener(nullptr); }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  std::vector<std::string> lines;
};

}  // namespace plumbline::test
