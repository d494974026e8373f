// bin/situations: draws situations with the decision that people expect, and takes them from logs of games.
#include <fmt/format.h>

#include <filesystem>
#include <functional>

#include "field/FieldFile.h"
#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "situation/SituationFile.h"
#include "situation/SituationKinds.h"
#include "situation/SituationOfLog.h"
#include "situation/SituationPage.h"
#include "situation/SituationPicture.h"

namespace {

using namespace plumbline;
namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> files;
  std::string folder, output, pictures, field, log, thread, kind;
  double time = 0;
};

FieldSize fieldOf(const Options& options) {
  return readFieldFile(options.field.empty() ? configPath("field.yaml") : options.field);
}

int draw(const Options& options) {
  const FieldSize field = fieldOf(options);
  for (const std::string& file : options.files) {
    StopSignal::throwIfCaught();
    const std::string name = fs::path(file).stem().string();
    const std::string picture = (fs::path(options.output) / (name + ".svg")).lexically_normal().string();
    writeFile(picture, situationPicture(readSituation(file), name, field));
    fmt::print("{}\n", picture);
  }
  return 0;
}

int page(const Options& options) {
  const FieldSize field = fieldOf(options);
  const auto entries = situationsIn(options.folder);
  fs::create_directories(options.pictures);
  for (const SituationEntry& entry : entries) {
    StopSignal::throwIfCaught();
    writeFile(options.pictures + "/" + entry.name + ".svg",
              situationPicture(entry.situation, fs::path(entry.file).stem().string(), field));
  }
  const fs::path pictures = fs::absolute(options.pictures).lexically_normal();
  const fs::path place = fs::absolute(options.output).lexically_normal().parent_path();
  writeFile(options.output, situationPage(entries, pictures.lexically_relative(place).generic_string(),
                                          "make pictures ARGS=situations"));
  fmt::print("{}: {} situations\n", options.output, entries.size());
  return 0;
}

int take(const Options& options) {
  record::LogReader log(options.log);
  const Situation situation =
      situationOfLog(log, log.thread(options.thread), options.time, situationKind(options.kind));
  writeFile(options.output, situationText(situation));
  fmt::print("{}: add what you expect, then draw it: bin/situations draw {}\n", options.output,
             options.output);
  return 0;
}

using Command = std::function<int(const Options&)>;

void declare(CommandLine& app, Options& options, Command& chosen) {
  app.requireCommand();
  CommandLine draws = app.command("draw", "Situations as SVG pictures");
  draws.option("files", options.files, "files of situations").required().existingFile();
  draws.option("-o,--output", options.output, "folder for NAME.svg of each [this one]").existingFolder();
  draws.option("--field", options.field, "file with the sizes of the field, as config/field.yaml")
      .existingFile();
  draws.whenChosen([&] { chosen = draw; });

  CommandLine pages = app.command("page", "A page in Markdown that shows all situations of a folder");
  pages.option("folder", options.folder, "with files, or with folders of them").required().existingFolder();
  pages.option("--pictures", options.pictures, "folder for the pictures").required();
  pages.option("-o,--output", options.output, "the page").required();
  pages.option("--field", options.field, "file with the sizes of the field, as config/field.yaml")
      .existingFile();
  pages.whenChosen([&] { chosen = page; });

  CommandLine takes = app.command("take", "A situation from an agent's log, as the player believed it");
  takes.option("log", options.log, "folder or .db3 file (bin/agent --log)").required();
  takes.option("--time", options.time, "of the log [s]; bin/logtool list says which there are")
      .notNegative()
      .required();
  takes.option("--decides", options.kind, "what decides in it").oneOf(situationKindNames()).required();
  takes.option("--thread", options.thread, "where the log has several");
  takes.option("-o,--output", options.output, "the file").required();
  takes.whenChosen([&] { chosen = take; });

  app.footer(
      "Exit status: 0; 2 for bad input; 130 after Ctrl-C.\n"
      "Examples:\n"
      "  bin/situations draw tests/data/situations/striker/nearTheSideLine.yaml\n"
      "  bin/agent --start-simulator --log game\n"
      "  bin/situations take game --time 12.5 --decides striker -o here.yaml\n"
      "  bin/situations page tests/data/situations --pictures pictures -o situations.md");
}

int runProgram(int argc, char** argv) {
  Options options;
  Command chosen;
  CommandLine app(
      "Situations with the decision that people expect: pictures, a page, and new ones from logs.",
      "situations");
  declare(app, options, chosen);
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  StopSignal stop;
  stop.catchSignals();
  return chosen(options);
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("situations", runProgram, argc, argv); }
