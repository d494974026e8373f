#pragma once
#include <string>
#include <vector>

#include "framework/Representation.h"
#include "math/Types.h"
#include "record/LogWriter.h"

namespace plumbline {

/// One of each shape.
REPRESENTATION(Shapes)
class Shapes : public ShapesBase {
public:
  bool flag = false;
  std::int8_t small = -3;
  double number = 0.5;
  std::string text = "none";
  Vec2 place = Vec2(1, 2);
  std::array<double, 3> angles{1, 2, 3};
  std::vector<std::string> names;
  std::vector<Vec3> points;
  void stream(InStream* in, OutStream* out) override {
    STREAM(flag);
    STREAM(small);
    STREAM(number);
    STREAM(text);
    STREAM(place);
    STREAM(angles);
    STREAM(names);
    STREAM(points);
  }
};

REPRESENTATION(Counter)
class Counter : public CounterBase {
public:
  int value = 0;
  void stream(InStream* in, OutStream* out) override { STREAM(value); }
};

namespace record {

/// The one thread of the logs below: Counter and Shapes.
RecordedThread exampleThread();
/// A message of each, for a cycle: the counter is its number, the shapes change with every third.
std::vector<std::string> exampleMessages(int number);
/// Writes cycles `first` to `last`, 20 ms each, without the numbers of `left out`.
void writeExampleLog(const std::string& folder, int first, int last, LogWriterOptions options = {},
                     const std::vector<int>& leftOut = {});

}  // namespace record
}  // namespace plumbline
