#include "situation/SituationPage.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <tuple>

#include "situation/SituationFile.h"
#include "situation/SituationKind.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t mostFiles = 1000;

/// What Markdown would take for marks.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>#|").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::vector<SituationEntry> situationsIn(const std::string& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".yaml") files.push_back(entry.path());
  if (files.empty()) throw std::runtime_error(folder + ": no situation there, that is no file NAME.yaml");
  if (files.size() > mostFiles)
    throw std::runtime_error(fmt::format("{}: {} files, more than {}", folder, files.size(), mostFiles));
  std::vector<SituationEntry> entries;
  for (const fs::path& file : files) {
    std::string name = file.lexically_relative(folder).replace_extension().generic_string();
    std::ranges::replace(name, '/', '-');
    entries.push_back({file.generic_string(), std::move(name), readSituation(file.string())});
  }
  std::ranges::sort(entries, {}, [](const SituationEntry& e) {
    const SituationTraits& kind = e.situation.kind->traits;
    return std::tuple(kind.order, std::string_view(kind.name), std::string_view(e.file));
  });
  return entries;
}

std::string situationPage(const std::vector<SituationEntry>& entries, const std::string& pictures,
                          const std::string& command) {
  std::string page = fmt::format(
      "# Situations\n\n"
      "Each file holds a situation and the decision that people expect; tests check every decision alone. "
      "White "
      "ring:\nthe player that decides. Blue: its team. Red: opponents. Dashed: where the ball and mates go. "
      "Yellow: what is expected.\n[How to write, draw and record one](situation-files.md).\n\n"
      "This page is made by `{}`.\n",
      command);
  const SituationEntry* before = nullptr;
  for (const SituationEntry& entry : entries) {
    const Situation& s = entry.situation;
    if (!before || before->situation.kind != s.kind) page += fmt::format("\n## {}\n", s.kind->traits.heading);
    before = &entry;
    const std::string decision = expectedWords(s);
    page +=
        fmt::format("\n### {}\n\n{}\n\n![{}]({}/{}.svg)\n\nExpected: {}. File: `{}`\n",
                    plain(fs::path(entry.file).stem().string()), plain(s.about), plain(entry.name), pictures,
                    entry.name, decision.empty() ? "not written yet" : plain(decision), entry.file);
  }
  return page;
}

}  // namespace plumbline
