#include "record/LogCompare.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "framework/NearestName.h"
#include "framework/StopSignal.h"
#include "record/Fields.h"
#include "record/LogReader.h"

namespace plumbline::record {
namespace {

struct Pair {
  std::size_t left, right;  ///< topics
  std::size_t place;        ///< of its update in a cycle
  std::optional<LogDifference> found;
};

struct Value {
  std::string path;
  FieldValue value;
};

std::vector<Value> valuesOf(const Schema& schema, const std::string& message) {
  std::vector<Value> values;
  visitFields(schema, message, [&](const std::string& path, const FieldValue& value) {
    values.push_back({path, value});
  });
  return values;
}

bool alike(const FieldValue& a, const FieldValue& b, double tolerance) {
  if (fieldText(a) == fieldText(b)) return true;
  const double distance = std::abs(fieldNumber(a) - fieldNumber(b));
  return tolerance > 0 && distance <= tolerance;
}

/// Finds the first field that differs; false: none.
bool differs(const Schema& leftForm, const std::string& left, const Schema& rightForm,
             const std::string& right, double tolerance, LogDifference& difference) {
  const auto a = valuesOf(leftForm, left), b = valuesOf(rightForm, right);
  for (std::size_t i = 0; i < std::max(a.size(), b.size()); ++i) {
    const bool both = i < a.size() && i < b.size() && a[i].path == b[i].path;
    if (both && alike(a[i].value, b[i].value, tolerance)) continue;
    difference.field = i < a.size() ? a[i].path : b[i].path;
    difference.left = i < a.size() ? fieldText(a[i].value) : "nothing";
    difference.right = !both && i < a.size() ? "nothing" : fieldText(b[i].value);
    return true;
  }
  return false;
}

class Comparer {
public:
  Comparer(LogReader& left, LogReader& right, const std::vector<std::string>& only, double tolerance)
      : left_(left), right_(right), only_(only), tolerance_(tolerance) {}

  LogComparison compare(const Progress& progress) {
    checkNames();
    for (const LogReader::Thread& thread : left_.threads()) {
      const auto other = std::ranges::find(right_.threads(), thread.recorded.name,
                                           [](const LogReader::Thread& t) { return t.recorded.name; });
      if (other == right_.threads().end()) {
        result_.missing.push_back(right_.path() + " has no thread " + thread.recorded.name);
        continue;
      }
      compareThread(thread, *other, progress);
    }
    std::ranges::stable_sort(result_.differences, {}, &LogDifference::cycle);
    return std::move(result_);
  }

private:
  bool wanted(const std::string& name) const {
    return only_.empty() || std::ranges::find(only_, name) != only_.end();
  }

  void checkNames() const {
    std::vector<std::string> names;
    for (const LogReader::Thread& thread : left_.threads())
      for (const RecordedTopic& topic : thread.recorded.topics) names.push_back(topic.representation);
    for (const std::string& name : only_)
      if (std::ranges::find(names, name) == names.end())
        throw std::runtime_error(left_.path() + " has no " + name + suggestion(name, names));
  }

  std::vector<Pair> pairsOf(const LogReader::Thread& left, const LogReader::Thread& right) {
    std::vector<Pair> pairs;
    const auto &ours = left.recorded.topics, &theirs = right.recorded.topics;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      const std::string& name = ours[i].representation;
      if (!wanted(name)) continue;
      const auto other = std::ranges::find(theirs, name, &RecordedTopic::representation);
      if (other == theirs.end()) {
        result_.missing.push_back(right_.path() + " has no " + name);
        continue;
      }
      const auto& steps = left.recorded.steps;
      const auto place = std::ranges::find_if(
          steps, [&](const std::string& step) { return step.ends_with(":update" + name); });
      pairs.push_back({i, static_cast<std::size_t>(other - theirs.begin()),
                       static_cast<std::size_t>(place - steps.begin()), std::nullopt});
    }
    for (const RecordedTopic& topic : theirs)
      if (wanted(topic.representation) &&
          std::ranges::find(ours, topic.representation, &RecordedTopic::representation) == ours.end())
        result_.missing.push_back(left_.path() + " has no " + topic.representation);
    std::ranges::stable_sort(pairs, {}, &Pair::place);
    return pairs;
  }

  void compareThread(const LogReader::Thread& left, const LogReader::Thread& right,
                     const Progress& progress) {
    std::vector<Pair> pairs = pairsOf(left, right);
    std::vector<std::string> ours(left.recorded.topics.size()), theirs(right.recorded.topics.size());
    std::size_t i = 0, j = 0;
    while (i < left.cycles.size() || j < right.cycles.size()) {
      StopSignal::throwIfCaught();
      if (progress && i % 256 == 0 && i < left.cycles.size())
        progress(static_cast<double>(i) / static_cast<double>(left.cycles.size()));
      const bool takeLeft = j >= right.cycles.size() ||
                            (i < left.cycles.size() && left.cycles[i].number <= right.cycles[j].number);
      const bool takeRight = i >= left.cycles.size() ||
                             (j < right.cycles.size() && right.cycles[j].number <= left.cycles[i].number);
      const auto take = [](LogReader& log, const LogReader::Thread& thread, std::size_t cycle,
                           std::vector<std::string>& values) {
        log.read(thread, thread.cycles[cycle],
                 [&](std::size_t topic, std::string_view message) { values[topic].assign(message); });
      };
      if (takeLeft) take(left_, left, i, ours);
      if (takeRight) take(right_, right, j, theirs);
      if (takeLeft && takeRight) {
        compareCycle(left, right, left.cycles[i], pairs, ours, theirs);
        result_.compared++;
      }
      result_.onlyLeft += takeLeft && !takeRight ? 1 : 0;
      result_.onlyRight += takeRight && !takeLeft ? 1 : 0;
      i += takeLeft ? 1 : 0;
      j += takeRight ? 1 : 0;
    }
    for (Pair& pair : pairs)
      if (pair.found) result_.differences.push_back(std::move(*pair.found));
  }

  void compareCycle(const LogReader::Thread& left, const LogReader::Thread& right,
                    const LogReader::Cycle& cycle, std::vector<Pair>& pairs,
                    const std::vector<std::string>& ours, const std::vector<std::string>& theirs) {
    for (Pair& pair : pairs) {
      const RecordedTopic &mine = left.recorded.topics[pair.left], &other = right.recorded.topics[pair.right];
      const std::string &a = ours[pair.left], &b = theirs[pair.right];
      if (a == b && mine.schema == other.schema) continue;
      LogDifference difference;
      if (!differs(mine.schema, a, other.schema, b, tolerance_, difference)) continue;
      if (!pair.found) {
        difference.thread = left.recorded.name;
        difference.representation = mine.representation;
        difference.cycle = cycle.number;
        difference.time = secondsOf(cycle.timestamp);
        pair.found = std::move(difference);
      }
      pair.found->cycles++;
    }
  }

  LogReader& left_;
  LogReader& right_;
  const std::vector<std::string>& only_;
  double tolerance_;
  LogComparison result_;
};

}  // namespace

LogComparison compareLogs(const std::string& left, const std::string& right,
                          const std::vector<std::string>& only, double tolerance, const Progress& progress) {
  LogReader a(left), b(right);
  return Comparer(a, b, only, tolerance).compare(progress);
}

}  // namespace plumbline::record
