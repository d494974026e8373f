#include "inspect/DrawingViewer.h"

#include <fmt/format.h>

#include "simspark/RoboVizWriter.h"

namespace plumbline::inspect {

DrawingViewer::DrawingViewer(const ViewerOptions& options, const DrawingOwner& owner)
    : sender_(options.address, options.port), owner_(owner) {}

void DrawingViewer::show(const std::string& id, const Drawing& drawing) {
  constexpr std::string_view prefix = "draw:";
  const std::string_view name =
      id.starts_with(prefix) ? std::string_view(id).substr(prefix.size()) : std::string_view(id);
  const bool right = owner_.right.load();
  // No other name contains its end: viewers show all sets that begin with the name they are sent.
  const std::string set = fmt::format("{}.{:02}.{}.", right ? "right" : "left", owner_.number.load(), name);
  std::string& before = sets_[id];
  if (!before.empty() && before != set) sender_.send(simspark::roboVizDatagrams(before, {}, right));
  before = set;
  sender_.send(simspark::roboVizDatagrams(set, drawing.shapes(), right));
}

}  // namespace plumbline::inspect
