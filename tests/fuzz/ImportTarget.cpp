// Recordings in other forms: a map and the table that it explains; two tables; tables in gzip; lists in
// cells.
#include <zlib.h>

#include <cmath>

#include "fuzz/Readers.h"
#include "gap/run/Cell.h"
#include "gap/run/OtherTables.h"
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

/// A map and two recordings, which become one.
void importTwoTables(std::string_view bytes) {
  const auto [map, tables] = halves(bytes);
  const auto [first, second] = halves(tables);
  const gap::ImportOptions options{scratchFile("map.yaml", map),
                                   {scratchFile("a.csv", first), scratchFile("b.csv", second)},
                                   "xl330_pendulum"};
  refusesInOneLine([&] {
    const gap::ImportedRun imported = gap::importRecordings(options);
    for (const auto& [name, column] : imported.run.channels) {
      require(column.size() == imported.run.size(), "a column of another length");
      for (const double x : column) require(!std::isinf(x), "a value that is not finite");
    }
    for (std::size_t i = 1; i < imported.run.size(); ++i)
      require(imported.run.t[i] > imported.run.t[i - 1], "times that do not grow");
  });
}

/// JSON lines, or a list of objects.
void jsonRecording(std::string_view bytes) {
  const std::string path = scratchFile("raw.json", bytes);
  refusesInOneLine([&] {
    const gap::Table table = gap::readRecording(path, {});
    require(table.names.size() == table.columns.size(), "a column without a name");
    for (const auto& column : table.columns)
      require(column.size() == table.columns[0].size(), "a column cut short");
  });
}

/// A cell, and the line that it stands in.
void listCell(std::string_view bytes) {
  std::vector<double> list;
  if (gap::listOf(bytes, {"nan"}, 16, list)) require(list.size() <= 16, "a list that is too long");
  std::vector<std::string_view> cells;
  for (const bool lists : {false, true}) {
    gap::splitCells(bytes, ',', lists, cells);
    require(!cells.empty(), "a line without a cell");
  }
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
      "stamp;goal_arm;angle;other\n5000000;90;0;7\n;90;0;7\n5010000;45;1024;7\n5020000;0;-1024;7\n",
      "robot: xl330_pendulum\nbase: fixed\nmotion: m\nseparator: \";\"\ntime: {from: t, unit: s}\n"
      "columns: [{to: pos.pendulum, from: q, unit: rad}]\n"
      "\n---8<---\n# a logger\n# t; q\n0,00;1,5\n# here\n0,01;-1,5e-3\n0,02;2\n"};
}
std::vector<std::string> jsonRecordingSeeds() {
  return {"[{\"t\": 0, \"q\": [1, 2]},\n{\"t\": 0.01, \"s\": \"}\\\"]\"}]\n",
          "{\"t\": 0, \"s\": {\"name\": [\"a\"], \"q\": [1]}}\n{\"t\": 0.01}\n"};
}
std::vector<std::string> importTwoTablesSeeds() {
  const std::string head = "robot: xl330_pendulum\nbase: fixed\nmotion: m\n";
  const std::string lists = "\n---8<---\nt,q\n0,\"[0.1, 0.2]\"\n0.01,\"0.3 0.4\"\n0.02,\n";
  return {head +
              "tables:\n  - time: {from: t, unit: s}\n    columns: [{to: cmd.pendulum, from: \"q[1]\", unit: "
              "rad}]\n"
              "  - time: {from: s, unit: ms, offset: 0.001, within: 0.004}\n    separator: \";\"\n"
              "    columns: [{to: pos.pendulum, from: p, unit: deg}]\n" +
              lists + "\n---8<---\ns;p\n0;1\n9;2\n19;3\n",
          head +
              "hold: linear\ntables:\n  - {time: {from: t}, columns: [{to: cmd.pendulum, from: \"q[0]\"}]}\n"
              "  - {time: {from: t}, columns: [{to: pos.pendulum, from: p}, {to: vel.pendulum, from: v}]}\n" +
              lists + "\n---8<---\nt,p,v\n0,10,0\n10,20,1\n20,30,1\n"};
}
std::vector<std::string> listCellSeeds() {
  return {"[0.1, 0.2]", "array('d', [1, 2])", "a,\"[1, 2]\",[3 4],5", "1 2;nan", "\"a\"\"b\",(1,2)"};
}
std::vector<std::string> gzipTableSeeds() {
  const std::string text = "t,cmd.a,pos.a\n0,0,0\n0.01,1,0.5\n0.02,,1\n";
  const std::string line(100000, '1');
  return {packed(text), packed(text).substr(0, 20), text, packed(line)};
}

const Registered importTableTarget({"importTable", importTable, importTableSeeds, 1200});
const Registered importTwoTablesTarget({"importTwoTables", importTwoTables, importTwoTablesSeeds, 800});
const Registered jsonRecordingTarget({"jsonRecording", jsonRecording, jsonRecordingSeeds, 2000});
const Registered listCellTarget({"listCell", listCell, listCellSeeds, 20000});
const Registered gzipTableTarget({"gzipTable", gzipTable, gzipTableSeeds, 6000});

}  // namespace
}  // namespace plumbline::fuzz
