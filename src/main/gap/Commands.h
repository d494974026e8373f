#pragma once

namespace CLI {
class App;
}

namespace plumbline::gap {

// One subcommand of bin/gap per file: adds its options to the program and does its work from a callback.
// Errors are exceptions whose text is one line; main then ends with 2. Ctrl-C and SIGTERM throw Stopped
// (framework/StopSignal.h) from within long work; main then ends with 130.
void addDiagnose(CLI::App& app);
void addCheck(CLI::App& app);
void addSettings(CLI::App& app);
void addImport(CLI::App& app);
void addEffects(CLI::App& app);
void addRecord(CLI::App& app);
void addReport(CLI::App& app);
void addReveal(CLI::App& app);
void addApply(CLI::App& app);
void addNext(CLI::App& app);
void addBlind(CLI::App& app);

}  // namespace plumbline::gap
