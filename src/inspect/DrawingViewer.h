#pragma once
#include <atomic>
#include <map>
#include <string>

#include "framework/Drawing.h"
#include "simspark/RoboVizSender.h"

namespace plumbline::inspect {

/// Who draws, for the names of the sets and for the side that the field is seen from; the module
/// DrawingFrames says so.
struct DrawingOwner {
  std::atomic<int> number{0};
  std::atomic<bool> right{false};  ///< of the viewer's field
};

struct ViewerOptions {
  std::string address = "127.0.0.1";
  int port = simspark::RoboVizSender::standardPort;
};

/// Shows drawings in RoboViz or a page that takes its datagrams (bin/webmonitor). The set of the drawing
/// draw:BallLocator:ball of the left team's number 7 is "left.07.BallLocator:ball.".
class DrawingViewer {
public:
  /// Throws std::runtime_error, one line, for what is no address.
  DrawingViewer(const ViewerOptions& options, const DrawingOwner& owner);
  /// In place of what it showed; an empty drawing hides it. Where the owner has become another one since, as
  /// when the server has assigned its number, what was shown under the old name is hidden.
  void show(const std::string& id, const Drawing& drawing);

private:
  simspark::RoboVizSender sender_;
  const DrawingOwner& owner_;
  std::map<std::string, std::string> sets_;  ///< by id, the name under which it is shown
};

}  // namespace plumbline::inspect
