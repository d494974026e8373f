#include "record/ExampleLog.h"

#include <algorithm>

#include "record/CdrStream.h"

namespace plumbline::record {

RecordedThread exampleThread() {
  return {"main",
          {"Count:execute", "Count:updateCounter", "Shape:execute", "Shape:updateShapes"},
          {{"Counter", "Count", schemaOf(representationLoader<Counter>())},
           {"Shapes", "Shape", schemaOf(representationLoader<Shapes>())}}};
}

std::vector<std::string> exampleMessages(int number) {
  Counter counter;
  counter.value = number;
  Shapes shapes;
  shapes.number = number / 3;
  shapes.names.assign(static_cast<std::size_t>(number / 3 % 4), "a b");
  CdrOutStream out;
  std::vector<std::string> messages;
  for (Representation* value : std::initializer_list<Representation*>{&counter, &shapes}) {
    out.clear();
    out.begin();
    value->stream(nullptr, &out);
    messages.emplace_back(out.bytes());
  }
  return messages;
}

void writeExampleLog(const std::string& folder, int first, int last, LogWriterOptions options,
                     const std::vector<int>& leftOut) {
  LogWriter writer(folder, options);
  writer.begin({exampleThread()});
  for (int number = first; number <= last; ++number) {
    if (std::ranges::find(leftOut, number) != leftOut.end()) continue;
    const auto messages = exampleMessages(number);
    writer.write({0,
                  static_cast<std::uint64_t>(number),
                  number * std::int64_t{20'000'000},
                  {messages.begin(), messages.end()}});
  }
  writer.finish();
}

}  // namespace plumbline::record
