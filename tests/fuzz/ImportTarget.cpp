// Recordings in other forms: a map and the table that it explains; tables in gzip.
#include <zlib.h>

#include "fuzz/Readers.h"
#include "gap/run/RunImport.h"
#include "gap/run/Table.h"

namespace plumbline::fuzz {
namespace {

/// A map and its recording.
void importTable(std::string_view bytes) {
  const auto [map, table] = halves(bytes);
  const std::string mapFile = scratchFile("map.yaml", map), recording = scratchFile("raw.csv", table);
  refusesInOneLine([&] {
    const gap::ImportedRun imported = gap::importRecording(mapFile, recording);
    for (const auto& [name, column] : imported.run.channels)
      require(column.size() == imported.run.size(), "a column of another length");
  });
}

void gzipTable(std::string_view bytes) {
  const std::string path = scratchFile("table.csv.gz", bytes);
  refusesInOneLine([&] {
    const gap::Table table = gap::readTable(path);
    require(table.names.size() == table.columns.size(), "a column without a name");
    for (const auto& column : table.columns)
      require(column.size() == table.columns[0].size(), "a column cut short");
  });
}

std::string packed(const std::string& text) {
  const std::string path = scratchFolder() + "/packed.gz";
  const gzFile file = gzopen(path.c_str(), "wb");
  gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
  gzclose(file);
  return contentOf(path);
}

std::vector<std::string> importTableSeeds() {
  return {
      "robot: xl330_pendulum\nbase: fixed\nmotion: \"m\"\nseparator: \";\"\nmissing: [x]\ntime: {from: "
      "stamp, unit: us}\n"
      "rename: {pendulum: arm}\ntiming: {pos_at_s: 0.004}\nservo:\n  pendulum: {kp: 30}\ncolumns:\n"
      "  - {to: \"cmd.*\", from: \"goal_*\", unit: deg}\n"
      "  - {to: pos.pendulum, from: angle, counts_per_turn: 4096, sign: -1, offset: 0.5}\n"
      "\n---8<---\n"
      "stamp;goal_arm;angle;other\n5000000;90;0;7\n;90;0;7\n5010000;45;1024;7\n5020000;0;-1024;7\n"};
}
std::vector<std::string> gzipTableSeeds() {
  const std::string text = "t,cmd.a,pos.a\n0,0,0\n0.01,1,0.5\n0.02,,1\n";
  const std::string line(100000, '1');
  return {packed(text), packed(text).substr(0, 20), text, packed(line)};
}

const Registered importTableTarget({"importTable", importTable, importTableSeeds, 1200});
const Registered gzipTableTarget({"gzipTable", gzipTable, gzipTableSeeds, 6000});

}  // namespace
}  // namespace plumbline::fuzz
