#pragma once
#include "framework/LogBuffer.h"
#include "framework/Plugin.h"

namespace plumbline {

/// Prints each step before it runs, `[thread] Module:execute`; part of the option -v.
class TracePlugin final : public Plugin {
public:
  void threadStarted(const ThreadInfo& thread) override { prefix_ = "[" + thread.name + "] "; }
  void beforeExecute(const Step& step) override { LogBuffer::instance().trace(prefix_ + step.label); }
  void beforeUpdate(const Step& step) override { LogBuffer::instance().trace(prefix_ + step.label); }

private:
  std::string prefix_;
};

}  // namespace plumbline
