#pragma once
#include <memory>
#include <string>

#include "framework/DebugPoints.h"
#include "framework/Drawing.h"

namespace plumbline::test {

/// What is drawn at the point with that id while `run` runs; empty if the code does not get there.
template <typename Run>
Drawing drawnBy(const std::string& id, Run&& run) {
  struct Look final : DebugRequest {
    void serve(DebugValue& value) noexcept override {
      if (value.drawing()) drawing = *value.drawing();
    }
    Drawing drawing;
  };
  DebugPoints::sites().expect(id, DebugKind::drawing);
  const auto look = std::make_shared<Look>();
  DebugPoints::sites().attach(id, look);
  run();
  DebugPoints::sites().detach(id, look);
  return look->drawing;
}

/// How many shapes of a form, as shapes::Circle, a drawing has.
template <typename Form>
std::size_t countOf(const Drawing& drawing) {
  std::size_t count = 0;
  for (const shapes::Shape& shape : drawing.shapes()) count += std::holds_alternative<Form>(shape.form);
  return count;
}

/// The place of a text; (0, 0, -1), below the ground, if there is no such text.
inline Vec3 placeOf(const Drawing& drawing, const std::string& text) {
  for (const shapes::Shape& shape : drawing.shapes())
    if (const auto* note = std::get_if<shapes::Annotation>(&shape.form); note && note->text == text)
      return note->position;
  return {0, 0, -1};
}

}  // namespace plumbline::test
