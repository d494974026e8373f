#include "modules/behavior/formation/FormationFile.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "framework/ConfigFile.h"
#include "framework/ReadFile.h"
#include "framework/WriteFile.h"
#include "framework/YamlDocument.h"
#include "math/Fingerprint.h"
#include "modules/behavior/formation/FormationTable.h"

namespace plumbline {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t maxBytes = 1 << 20;
constexpr double sameNumber = 5e-3;  ///< what two decimals cannot distinguish [m]

using Table = std::vector<std::vector<double>>;

std::string textOf(const fs::path& file) {
  try {
    return readFile(file, maxBytes);
  } catch (const FileProblem& problem) {
    throw std::runtime_error(file.string() + ": " + problem.what());
  }
}

std::string revisionOf(const std::string& text) {
  Fingerprint print;
  for (const char c : text) print.add(static_cast<unsigned char>(c));
  return fmt::format("{:016x}", print.value());
}

/// Two decimals at most, one at least.
std::string number(double value) {
  std::string text = fmt::format("{:.2f}", std::abs(value) < sameNumber ? 0.0 : value);
  if (text.back() == '0') text.pop_back();
  return text;
}

struct Change {
  std::size_t begin, length;
  std::string text;
};

/// What turns a table of the file into another one of the same shape.
void addChanges(const YAML::Node& rows, const Table& wanted, const std::string& text, const std::string& path,
                std::vector<Change>& changes) {
  for (std::size_t j = 0; j < wanted.size(); ++j)
    for (std::size_t i = 0; i < wanted[j].size(); ++i) {
      const YAML::Node cell = rows[j][i];
      if (std::abs(cell.as<double>() - wanted[j][i]) < sameNumber) continue;
      const std::string& old = cell.Scalar();
      const auto begin = static_cast<std::size_t>(cell.Mark().pos);
      if (begin > text.size() || text.compare(begin, old.size(), old) != 0)
        throw std::runtime_error(path +
                                 ": the layout of this file does not allow this change; edit it by hand");
      changes.push_back({begin, old.size(), number(wanted[j][i])});
    }
}

bool sameShape(const Table& a, const Table& b) {
  return std::ranges::equal(a, b, {}, &std::vector<double>::size, &std::vector<double>::size);
}

void check(const FormationDraft& draft, const FormationDraft& now) {
  const auto fits = [](const FormationDraftPlace& a, const FormationDraftPlace& b) {
    return a.name == b.name && sameShape(a.x, b.x) && sameShape(a.y, b.y);
  };
  if (draft.ballX != now.ballX || draft.ballY != now.ballY ||
      !std::ranges::equal(draft.places, now.places, fits))
    throw std::runtime_error(now.file + ": the draft has other places or balls than the file");
  for (const FormationDraftPlace& place : draft.places)
    for (const Table* table : {&place.x, &place.y})
      for (const std::vector<double>& row : *table)
        for (const double value : row)
          if (!(std::abs(value) <= FormationTable::farthest))
            throw std::runtime_error(fmt::format("{}: {}: {} is no number from {:g} to {:g}", now.file,
                                                 place.name, value, -FormationTable::farthest,
                                                 FormationTable::farthest));
}

std::string edited(const FormationDraft& draft, const std::string& text, const std::string& path) {
  const YAML::Node list = parseYaml(text, path)["places"];
  std::vector<Change> changes;
  for (std::size_t k = 0; k < draft.places.size(); ++k) {
    addChanges(list[k]["x"], draft.places[k].x, text, path, changes);
    addChanges(list[k]["y"], draft.places[k].y, text, path, changes);
  }
  std::ranges::sort(changes, std::greater<>(), &Change::begin);
  std::string result = text;
  for (const Change& change : changes) result.replace(change.begin, change.length, change.text);
  return result;
}

}  // namespace

FormationDraft FormationFile::read() const {
  FormationDraft draft;
  draft.file = file_.string();
  try {
    draft.revision = revisionOf(textOf(file_));
    const ConfigFile file(file_.string());
    const FormationTable table(file.root());  // whose errors have line and key
    draft.ballX = file.root().get<std::vector<double>>("ballX");
    draft.ballY = file.root().get<std::vector<double>>("ballY");
    for (const ConfigSection& section : file.root().list("places"))
      draft.places.push_back(
          {section.get<std::string>("name"), section.get<Table>("x"), section.get<Table>("y")});
  } catch (const std::exception& error) {
    draft.comment = error.what();
  }
  return draft;
}

bool FormationFile::write(const FormationDraft& draft) const {
  const FormationDraft now = read();
  if (!now.comment.empty()) throw std::runtime_error(now.comment);
  const std::string text = textOf(file_);
  if (now.revision != draft.revision || revisionOf(text) != draft.revision)
    throw std::runtime_error(file_.string() + " was changed by somebody else; nothing is written");
  check(draft, now);
  const std::string result = edited(draft, text, file_.string());
  if (result == text) return false;
  writeFile(fs::canonical(file_).string(), result);
  return true;
}

}  // namespace plumbline
