#pragma once
#include <sys/types.h>

#include <string>

#include "framework/CrashRecord.h"

namespace plumbline {

/// "SIGSEGV" and so on; safe in a signal handler.
const char* signalName(int signal);

/// Writes the crash log about the process `agent` to `path`: to another file first, which is then moved.
/// Returns false if that was not possible.
bool writeCrashReport(const CrashRecord& record, pid_t agent, const std::string& path);

}  // namespace plumbline
