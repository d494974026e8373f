#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "framework/StopSignal.h"
#include "framework/TextLines.h"
#include "gap/run/JsonArray.h"
#include "gap/run/OtherTables.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr double lost = std::numeric_limits<double>::quiet_NaN();

/// The names that an object gives to its lists' elements; null: none.
const json* namesIn(const json& object) {
  for (const char* key : {"name", "names", "joint_names", "joints"}) {
    const auto found = object.find(key);
    if (found == object.end() || !found->is_array() || found->empty()) continue;
    if (std::ranges::all_of(*found, [](const json& name) { return name.is_string(); })) return &*found;
  }
  return nullptr;
}

/// Of TextLines or JsonArray.
template <class Entries>
class Reader {
public:
  Reader(const std::string& path, const char* entry) : lines_(path, maxLineLength), entry_(entry) {}

  Table read() {
    for (std::string_view text; lines_.next(text);) {
      StopSignal::throwIfCaught();
      if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
      addLine(text);
    }
    if (rows_ < 2)
      throw RunError(lines_.path() + ": has " + std::to_string(rows_) + " " + entry_ +
                     " of data; a run needs two at least");
    for (std::vector<double>& column : table_.columns) column.resize(rows_, lost);
    return std::move(table_);
  }

private:
  void addLine(std::string_view text) {
    json object;
    try {
      object = parseJson(text);
    } catch (const JsonError& error) {
      lines_.fail(error.what());
    }
    if (!object.is_object()) lines_.fail("is no object; each line is one: {\"t\": 0.01, ...}");
    ++rows_;
    addObject("", object);
    if (rows_ * table_.names.size() > maxCells)
      lines_.fail("more than " + std::to_string(maxCells) + " cells; cut the run into shorter ones");
  }

  void addObject(const std::string& head, const json& object) {
    const json* names = namesIn(object);
    for (const auto& [key, value] : object.items()) {
      if (&value == names) continue;
      const std::string name = head + key;
      if (value.is_array() && names && value.size() == names->size())
        for (std::size_t i = 0; i < value.size(); ++i)
          add(name + "." + (*names)[i].get<std::string>(), value[i]);
      else
        add(name, value);
    }
  }

  void add(const std::string& name, const json& value) {
    if (value.is_object()) return addObject(name + ".", value);
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) add(name + "." + std::to_string(i), value[i]);
      return;
    }
    std::vector<double>& column = columnOf(name);
    if (column.size() >= rows_) lines_.fail("column " + name + " occurs twice");
    column.resize(rows_ - 1, lost);
    const bool number = value.is_number() && std::isfinite(value.get<double>());
    column.push_back(number ? value.get<double>() : value.is_boolean() ? value.get<bool>() : lost);
    if (value.is_string())
      table_.bad.try_emplace(name, Table::BadCell{lines_.line(), shownText(value.get<std::string>())});
  }

  std::vector<double>& columnOf(const std::string& name) {
    const auto [at, fresh] = index_.try_emplace(name, table_.names.size());
    if (fresh) {
      if (!canBeName(name)) lines_.fail("\"" + shownText(name) + "\" is not allowed as the name of a column");
      if (table_.names.size() >= maxColumns)
        lines_.fail("more than " + std::to_string(maxColumns) + " columns");
      table_.names.push_back(name);
      table_.columns.emplace_back();
    }
    return table_.columns[at->second];
  }

  Entries lines_;
  const std::string entry_;
  Table table_;
  std::map<std::string, std::size_t> index_;
  std::size_t rows_ = 0;
};

}  // namespace

Table readJsonLines(const std::string& path) {
  try {
    if (JsonArray::isIn(path)) return Reader<JsonArray>(path, "entries").read();
    return Reader<TextLines>(path, "lines").read();
  } catch (const TextError& error) {
    throw RunError(error.what());
  }
}

}  // namespace plumbline::gap
