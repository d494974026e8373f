// Logs of agents: bags of ROS 2, and messages by their schema.
#include <filesystem>

#include "fuzz/Readers.h"
#include "record/Fields.h"
#include "record/LogReader.h"
#include "record/LogWriter.h"
#include "record/Schema.h"

namespace plumbline::fuzz {
namespace {

using namespace record;

/// A log of one file.
void logFile(std::string_view bytes) {
  const std::string path = scratchFile("log_0.db3", bytes);
  refusesInOneLine([&] {
    LogReader log(path);
    for (const LogReader::Thread& thread : log.threads()) {
      std::size_t count = 0;
      for (const LogReader::Cycle& cycle : thread.cycles) {
        if (++count > 100) break;
        log.read(thread, cycle, [&](std::size_t topic, std::string_view message) {
          require(topic < thread.recorded.topics.size(), "a message of no topic");
          refusesInOneLine(
              [&] { visitFields(thread.recorded.topics[topic].schema, message, [](auto&, auto&) {}); });
        });
      }
    }
  });
}

/// A schema and a message of it.
void logMessage(std::string_view bytes) {
  const std::string_view text = halves(bytes)[0], message = halves(bytes)[1];
  refusesInOneLine([&] {
    const Schema schema = schemaFromText(text);
    require(schemaFromText(schemaText(schema)) == schema, "a schema changes when it is read back");
    std::size_t fields = 0;
    visitFields(schema, message, [&](const std::string&, const FieldValue& value) {
      fieldText(value);
      ++fields;
    });
    require(fields <= 4096 + 8 * message.size(), "more fields than bytes");
  });
}

constexpr const char* exampleSchema = "{position:{x:f8 y:f8} valid:b angles:{f8*3} names:[s]}";

std::string exampleMessage() {
  using std::string_literals::operator""s;
  std::string bytes = "\0\1\0\0"s;
  bytes += std::string(16, '\x3f') + "\1"s + std::string(7, '\0') + std::string(24, '\x40') +
           "\1\0\0\0\2\0\0\0a\0"s;
  return bytes;
}

std::vector<std::string> logFileSeeds() {
  const std::string folder = scratchFolder() + "/seedlog";
  std::filesystem::remove_all(folder);
  LogWriter writer(folder, {});
  writer.begin({{"main", {"A:execute", "A:updateB"}, {{"B", "A", schemaFromText(exampleSchema)}}}});
  const std::string text = exampleMessage();
  for (std::uint64_t n = 1; n < 6; ++n)
    writer.write({0, n, static_cast<std::int64_t>(n) * 20'000'000, {text}});
  writer.finish();
  return contentsOf(folder, ".db3");
}

std::vector<std::string> logMessageSeeds() {
  const std::string between(separator);
  return {exampleSchema + between + exampleMessage(), "{a:i1 b:u8 c:[{x:f4}]}" + between + exampleMessage(),
          "[[[s]]]" + between + exampleMessage(), "{r:r16}" + between + exampleMessage()};
}

const Registered logFileTarget({"logFile", logFile, logFileSeeds, 1200});
const Registered logMessageTarget({"logMessage", logMessage, logMessageSeeds, 12000});

}  // namespace
}  // namespace plumbline::fuzz
