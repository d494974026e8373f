#pragma once
#include <utility>

#include "framework/DebugSite.h"
#include "framework/Drawing.h"
#include "framework/DrawingNames.h"

// Drawings in the code (doc/reference/debug-protocol.md): off by default, and then a relaxed load, as all of
// DebugSite.h. An id is a string literal, `draw:BallLocator:ball`.
namespace plumbline {

/// Draws when the first of those who want it asks.
template <typename Draw>
class DrawingValue final : public DebugValue {
public:
  explicit DrawingValue(Draw draw) : draw_(std::move(draw)) {}
  void write(OutStream& out) const override {
    const auto& shapes = drawing()->shapes();
    out.beginList(shapes.size(), true);
    for (const shapes::Shape& shape : shapes) shapes::writeShape(out, shape);
    out.endList();
  }
  const Drawing* drawing() const override {
    if (!drawn_) draw_(drawing_);
    drawn_ = true;
    return &drawing_;
  }

private:
  Draw draw_;
  mutable Drawing drawing_;
  mutable bool drawn_ = false;
};

namespace debugging {
template <typename Draw>
void draw(DebugPoint& point, Draw&& code) {
  DrawingValue<std::decay_t<Draw>> value(std::forward<Draw>(code));
  point.pass(value);
}
}  // namespace debugging
}  // namespace plumbline

/// DEBUG_DRAWING(id, code): while somebody looks, the code draws on `drawing`, a Drawing that is empty:
///
///     DEBUG_DRAWING("draw:BallLocator:ball", drawing.in(DrawingFrame::robot);
///                   drawing.sphere(position, 0.042, colours::orange));
#define DEBUG_DRAWING(id, ...)                                                                              \
  do {                                                                                                      \
    static_cast<void>(&::plumbline::debugging::NotedDrawing<id>::noted);                                    \
    PLUMBLINE_DEBUG_POINT(                                                                                  \
        id, drawing,                                                                                        \
        ::plumbline::debugging::draw(plumblinePoint, [&](::plumbline::Drawing& drawing) { __VA_ARGS__; })); \
  } while (false)
