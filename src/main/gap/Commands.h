#pragma once

namespace CLI {
class App;
}

namespace plumbline::gap {

// One subcommand of bin/gap per file: adds its options to the program and does its work from a callback. What
// goes wrong is an exception whose text is one line; main ends with 2 then. Ctrl-C and a termination are
// thrown as Stopped (framework/StopSignal.h) from the midst of whatever takes long; main ends with 130 then.
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
