#include "framework/DrawingNames.h"

#include <mutex>
#include <set>
#include <stdexcept>
#include <string_view>

#include "framework/NearestName.h"

namespace plumbline {
namespace {

constexpr std::string_view idPrefix = "draw:";

struct NotedDrawings {
  std::mutex mutex;
  std::set<std::string> ids;
};
// Never destroyed: plug-ins may come and go until the very end.
NotedDrawings& notedDrawings() {
  static auto* drawings = new NotedDrawings;
  return *drawings;
}

std::string_view withoutPrefix(std::string_view id) {
  return id.substr(id.starts_with(idPrefix) ? idPrefix.size() : 0);
}

bool chooses(std::string_view name, std::string_view drawing) {
  return !name.empty() && drawing.starts_with(name) &&
         (drawing.size() == name.size() || drawing[name.size()] == ':');
}

/// What may be asked for: the drawings, and what they begin with.
std::vector<std::string> candidatesOf(const std::vector<std::string>& ids) {
  std::set<std::string> candidates;
  for (const std::string& id : ids) {
    const std::string_view name = withoutPrefix(id);
    candidates.emplace(name);
    candidates.emplace(name.substr(0, name.find(':')));
  }
  return {candidates.begin(), candidates.end()};
}

}  // namespace

namespace debugging {
bool noteDrawing(const char* id) {
  NotedDrawings& drawings = notedDrawings();
  const std::lock_guard lock(drawings.mutex);
  drawings.ids.insert(id);
  return true;
}
}  // namespace debugging

std::vector<std::string> drawingNames() {
  NotedDrawings& drawings = notedDrawings();
  const std::lock_guard lock(drawings.mutex);
  return {drawings.ids.begin(), drawings.ids.end()};
}

std::vector<std::string> chosenDrawings(const std::vector<std::string>& names) {
  const std::vector<std::string> ids = drawingNames();
  std::set<std::string> chosen;
  for (const std::string& given : names) {
    const std::string name(withoutPrefix(given));
    bool any = false;
    for (const std::string& id : ids) {
      if (!chooses(name, withoutPrefix(id))) continue;
      chosen.insert(id);
      any = true;
    }
    if (any) continue;
    throw std::invalid_argument("no drawing is called \"" + name.substr(0, 60) + '"' +
                                suggestion(name.substr(0, 60), candidatesOf(ids)));
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace plumbline
