#include "framework/YamlDocument.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "framework/ConfigurationError.h"
#include "framework/ReadFile.h"
#include "framework/SingleLine.h"
#include "framework/YamlLimits.h"

namespace plumbline {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  stream.exceptions(std::ios::badbit);  // a lack of memory is not the end of the text
  for (std::string line; std::getline(stream, line);) lines.push_back(std::move(line));
  return lines;
}

[[noreturn]] void failSecond(const std::string& path, const std::string& text, const YAML::Node& first,
                             const YAML::Node& second) {
  const std::vector<std::string> lines = linesOf(text);
  // Counted from 0, as yaml-cpp does. An empty document has no place of its own.
  const int begin = std::max(0, first.Mark().line);
  const int last = static_cast<int>(lines.size()) - 1;
  const int end = second.IsNull() ? last : std::min(second.Mark().line, last);
  for (int i = begin; i <= end; ++i) {
    const std::string& line = lines[static_cast<std::size_t>(i)];
    const bool separates = line.starts_with("---") || line.starts_with("...");
    // A --- above the first key only says where that document begins.
    if (separates && (i > begin || first.IsNull()))
      throw ConfigurationError(path + ":" + std::to_string(i + 1) + ": a second document begins at " +
                               line.substr(0, 3) + "; a file holds one: take this line out");
  }
  throw ConfigurationError(path + ":" + std::to_string(end + 1) +
                           ": is indented less than the first key in line " + std::to_string(begin + 1) +
                           "; all keys of a map begin in the same column");
}

}  // namespace

YAML::Node parseYaml(const std::string& text, const std::string& path) {
  try {
    checkYamlLimits(text, path);
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.empty()) return YAML::Node();
    if (documents.size() > 1) failSecond(path, text, documents[0], documents[1]);
    return documents.front();
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(path + ":" + std::to_string(error.mark.line + 1) +
                             ": broken YAML: " + singleLine(error.msg));
  }
}

YAML::Node readYaml(const std::string& path, std::size_t maxBytes) {
  std::string text;
  try {
    text = readFile(path, maxBytes);
  } catch (const FileProblem& problem) {
    throw ConfigurationError(path + ": " + problem.what());
  }
  return parseYaml(text, path);
}

}  // namespace plumbline
