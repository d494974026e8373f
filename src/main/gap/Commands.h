#pragma once
#include "framework/CommandLine.h"

namespace plumbline::gap {

// One subcommand of bin/gap per file: adds its options to the program and does its work from a callback.
// Errors are exceptions whose text is one line; main then ends with 2. Ctrl-C and SIGTERM throw Stopped
// (framework/StopSignal.h) from within long work; main then ends with 130.
void addDiagnose(CommandLine& app);
void addCheck(CommandLine& app);
void addSettings(CommandLine& app);
void addImport(CommandLine& app);
void addEffects(CommandLine& app);
void addRecord(CommandLine& app);
void addReport(CommandLine& app);
void addReveal(CommandLine& app);
void addApply(CommandLine& app);
void addNext(CommandLine& app);
void addBlind(CommandLine& app);

}  // namespace plumbline::gap
