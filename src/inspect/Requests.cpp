#include "inspect/Requests.h"

#include <exception>

#include "framework/TextStream.h"
#include "inspect/TreeStream.h"

namespace plumbline::inspect {

namespace {

std::int64_t nowNanoseconds() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

bool Pace::due() {
  const std::int64_t now = nowNanoseconds();
  if (now < next_.load()) return false;
  next_.store(now + static_cast<std::int64_t>(1e9 * seconds_));
  return true;
}

ReadRequest::ReadRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once, Interval interval)
    : number_(number),
      outbox_(std::move(outbox)),
      once_(once),
      interval_(interval),
      pace_(interval.seconds) {}

bool ReadRequest::due() {
  if (once_) return true;
  if (const auto until = pausesUntil_.load(std::memory_order_relaxed); until > 0) {
    if (nowNanoseconds() < until) return false;
    pausesUntil_.store(0, std::memory_order_relaxed);
  }
  if (interval_.cycles > 0) return passages_.fetch_add(1) % interval_.cycles == 0;
  return pace_.due();
}

void ReadRequest::serve(DebugValue& value) noexcept {
  if (ended_.load(std::memory_order_relaxed) || !due()) return;
  if (once_ && ended_.exchange(true)) return;
  try {
    Outcome outcome{number_, Outcome::Kind::value, {}};
    TextOutStream out(outcome.text);
    value.write(out);
    if (!outbox_->push(std::move(outcome)) && once_) ended_.store(false);  // in the next cycle, then
  } catch (const std::exception&) {                                        // no memory: nothing was read
  }
}

void ReadRequest::pause(double seconds) {
  pausesUntil_.store(nowNanoseconds() + static_cast<std::int64_t>(1e9 * seconds), std::memory_order_relaxed);
}

SetRequest::SetRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once, std::string path,
                       Tree wanted)
    : number_(number),
      outbox_(std::move(outbox)),
      once_(once),
      path_(std::move(path)),
      wanted_(std::move(wanted)) {}

std::string SetRequest::apply(DebugValue& value, std::string& was) {
  Tree before;
  TreeOutStream out(before);
  value.write(out);
  Tree after = before;
  std::string error;
  Tree* part = findPart(after, path_, error);
  if (!part) return error;
  const std::string label = part->label;
  if (!answered_.load(std::memory_order_relaxed)) was = treeText(*part);
  *part = wanted_;
  part->label = label;
  TreeInStream in(after);
  try {
    value.read(in);
  } catch (const std::exception& problem) {  // a value may have to look something up
    in.fail(problem.what());
  }
  std::string problem = in.ok() ? value.problem() : in.problem();
  if (problem.empty()) return {};
  TreeInStream back(before, true);
  value.read(back);
  return (in.located() ? "." : ": ") + problem;
}

void SetRequest::serve(DebugValue& value) noexcept {
  if (ended_.load(std::memory_order_relaxed)) return;
  try {
    std::string was;
    const std::string error = apply(value, was);
    if (!error.empty()) {
      ended_.store(true);
      outbox_->push({number_, Outcome::Kind::error, error});
      return;
    }
    if (once_) ended_.store(true);
    if (!answered_.load(std::memory_order_relaxed))
      answered_.store(outbox_->push({number_, Outcome::Kind::done, std::move(was)}));
  } catch (const std::exception&) {  // no memory
    ended_.store(true);
    outbox_->push({number_, Outcome::Kind::error, ": no memory"});
  }
}

DrawRequest::DrawRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once)
    : number_(number), outbox_(std::move(outbox)), once_(once) {}

void DrawRequest::serve(DebugValue& value) noexcept {
  if (ended_.load(std::memory_order_relaxed) || !pace_.due()) return;
  try {
    const Drawing* drawing = value.drawing();
    if (!drawing) return;
    Outcome outcome{number_, Outcome::Kind::value, {}, std::make_shared<const Drawing>(*drawing)};
    if (!outbox_->push(std::move(outcome))) return;
    if (!answered_.load(std::memory_order_relaxed))
      answered_.store(outbox_->push({number_, Outcome::Kind::done, {}}));
    if (once_) ended_.store(true);
  } catch (const std::exception&) {  // no memory: nothing was drawn
  }
}

RunRequest::RunRequest(std::uint64_t number, std::shared_ptr<Outbox> outbox, bool once)
    : number_(number), outbox_(std::move(outbox)), once_(once) {}

bool RunRequest::run() noexcept {
  if (ended_.load(std::memory_order_relaxed)) return false;
  return !once_ || !ended_.exchange(true);
}

void RunRequest::output(std::string_view text) noexcept {
  if (once_ && answered_.load(std::memory_order_relaxed)) return;
  try {
    outbox_->push({number_, Outcome::Kind::value, std::string(text)});
  } catch (const std::exception&) {  // no memory: nothing was said
  }
}

void RunRequest::failed(std::string_view text) noexcept {
  if (answered_.load(std::memory_order_relaxed)) return;
  try {
    answered_.store(outbox_->push({number_, Outcome::Kind::error, ": " + std::string(text)}));
  } catch (const std::exception&) {  // no memory: the client hears nothing until its time is over
  }
}

void RunRequest::finished() noexcept {
  if (answered_.load(std::memory_order_relaxed)) return;
  answered_.store(outbox_->push({number_, Outcome::Kind::done, {}}));
}

}  // namespace plumbline::inspect
