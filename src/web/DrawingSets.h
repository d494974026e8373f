#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "web/RoboVizParser.h"

namespace plumbline::web {

/// What agents have drawn: each set has what is shown and what is being drawn. Bounded: beyond the limits
/// shapes are dropped, so that no agent fills the memory.
class DrawingSets {
public:
  static constexpr std::size_t maxSets = 2000, maxShapesOfSet = 4000, maxShapes = 40000;

  /// True if what is shown may have changed.
  bool apply(const DrawingCommand& command);
  void clear();

  /// Shapes shown.
  std::size_t numShown() const;
  /// {"kind":"drawings","sets":[{"name":,"shapes":[...]}],"texts":[...],"selected":}. A shape is a list:
  /// ["circle",colour,x,y,radius,thickness], ["line",colour,x,y,z,x,y,z,thickness],
  /// ["point",colour,x,y,z,size], ["sphere",colour,x,y,z,radius], ["polygon",colour,x,y,z,...],
  /// ["text",colour,x,y,z,text]; a colour is "#rrggbb" or "#rrggbbaa".
  std::string toJson() const;

private:
  struct Set {
    std::vector<Shape> shown, drawn;
  };
  bool add(const Shape& shape);
  bool swap(const std::string& prefix);

  std::map<std::string, Set> sets_;
  std::map<AgentName, AgentText> texts_;
  std::optional<AgentName> selected_;
  std::size_t numShapes_ = 0;  ///< shown and drawn, of all sets
};

}  // namespace plumbline::web
