#include "framework/ParameterPage.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "framework/Module.h"

namespace plumbline {
namespace {

std::string boundText(double value) {
  if (std::isinf(value)) return value > 0 ? "∞" : "-∞";
  return shortestText(value);
}

std::string allowed(const Parameter& parameter) {
  std::string text;
  for (const std::string& word : parameter.words) text += (text.empty() ? "" : ", ") + word;
  if (!text.empty()) return text;
  const Range& range = parameter.range;
  if (std::isinf(range.min) && std::isinf(range.max)) return "";
  return boundText(range.min) + " … " + boundText(range.max);
}

/// A bar would end the cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2))
    text.insert(at, 1, '\\');
  return text;
}

/// Rows of a list's parameters. A group of parameters that were all described before (a set that differs from
/// another one) is one row.
class Rows {
public:
  explicit Rows(GroupNames names) : names_(names) {}

  void add(const ParameterList& list, void* owner, const std::string& prefix) {
    for (const ParameterList::Entry& entry : list.entries()) {
      const std::string path = prefix + entry.parameter.name;
      if (!entry.group) {
        described_.insert(entry.pointer);
        addRow(path, entry.parameter, entry.pointer(owner));
      } else if (isDescribed(*entry.group)) {
        text += "| `" + path + ".` … | | | | | " + cell(entry.parameter.comment) + ": names as above |\n";
      } else {
        add(*entry.group, entry.groupOf(owner), names_ == GroupNames::path ? path + "." : prefix);
      }
    }
  }

  std::string text;

private:
  bool isDescribed(const ParameterList& list) const {
    return std::ranges::all_of(list.entries(), [&](const ParameterList::Entry& entry) {
      return entry.group ? isDescribed(*entry.group) : described_.contains(entry.pointer);
    });
  }
  void addRow(const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
    text += "| `" + path + "` | " + parameterType(value) + " | " + cell(parameter.defaultText) + " | " +
            parameter.unit + " | " + allowed(parameter) + " | " + cell(parameter.comment) + " |\n";
  }

  GroupNames names_;
  std::set<ParameterList::Pointer> described_;
};

}  // namespace

std::string parameterTable(const ParameterList& parameters, void* owner, GroupNames names) {
  Rows rows(names);
  rows.add(parameters, owner, "");
  return "| parameter | type | default | unit | range | what it does |\n|---|---|---|---|---|---|\n" +
         rows.text;
}

std::string parameterPage(const Registry& registry, const std::map<std::string, ParameterFile>& files) {
  std::string page =
      "# Parameters of the modules\n\n"
      "`bin/agent --parameters` made this page. Values that differ from these are in `config/<Module>.yaml`, "
      "which\nyou create if it does not exist; a group with a file of its own is an error there that names "
      "the "
      "file. The\nparameters of a group are in a map with the group's name. A value out of its range and an "
      "unknown key are errors\nat the start, with file and line. A module that is not on this page has no "
      "parameters.\n";
  for (const auto& [name, loader] : registry.modules()) {
    const ParameterList& parameters = loader->description().parameters;
    if (parameters.empty()) continue;
    // The types are those of the members: a module made only to look at them.
    page += "\n## " + name + "\n\n" + parameterTable(parameters, loader->create().get());
  }
  if (!files.empty())
    page +=
        "\n# Parameters of other files\n\n"
        "These files of `config/` are no module's. They, too, hold only the values that differ.\n";
  for (const auto& [name, file] : files)
    page += "\n## " + name + ".yaml\n\n" + file.comment + "\n\n" +
            parameterTable(*file.parameters, file.make().get());
  return page;
}

}  // namespace plumbline
