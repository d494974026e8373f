// bin/gap import: brings recordings of another form into a run folder.
#include <cstdio>
#include <memory>

#include "gap/run/RunFile.h"
#include "gap/run/RunImport.h"
#include "main/gap/Commands.h"
#include "main/gap/RecordingsFolder.h"

namespace plumbline::gap {

void addImport(CommandLine& app) {
  struct Options {
    ImportOptions import;
    std::string out;
    bool force = false;
  };
  auto options = std::make_shared<Options>();
  CommandLine command = app.command("import", "Turns tables of another recorder into a run");
  command
      .option("recordings", options->import.recordings,
              "csv or csv.gz; JSON lines (.jsonl, .ndjson) or a list of objects (.json); a bag of ROS 2 (its "
              "folder, or .db3). Several of "
              "one motion, in the order of tables in the map, become one run")
      .required();
  command.option("--map", options->import.map, "YAML file: which column is which channel, units, signs")
      .required();
  command.option("--robot", options->import.robot,
                 "Name in config/robots, or a file: its limits show units that the map does not name [the "
                 "map's robot]");
  command.option("-o,--out", options->out, "Run folder to write").required();
  command.flag("--force", options->force, "Replaces an existing recording");
  command.footer(
      "Examples:\n  bin/gap import --map my_logger.yaml raw.csv -o runs/sweep\n"
      "  bin/gap import --map two_logs.yaml commands.csv readings.csv -o runs/sweep\n"
      "  bin/gap import --map my_logger.yaml --robot my_leg.urdf raw.csv -o runs/sweep\n"
      "  bin/gap import --map my_robot.yaml rosbag2_2026_03_01 -o runs/sweep");
  command.whenChosen([options] {
    RecordingsFolder out(options->out, options->force);
    const ImportedRun imported = importRecordings(options->import);
    writeRun(imported.run, out.partial());
    out.putInPlace();
    std::printf("%s: %zu cycles, %zu channels\n", options->out.c_str(), imported.run.size(),
                imported.run.channels.size());
    for (const std::string& line : imported.notes) std::printf("  %s\n", line.c_str());
    for (const std::string& line : imported.merged) std::printf("  %s\n", line.c_str());
    for (const std::string& line : imported.guesses)
      std::printf("  %s; if not, write its unit into the map\n", line.c_str());
    for (const std::string& column : imported.unused)
      std::printf("  column not in the map: %s\n", column.c_str());
    if (imported.linesWithoutTime)
      std::printf("  lines without a time, dropped: %zu\n", imported.linesWithoutTime);
  });
}

}  // namespace plumbline::gap
