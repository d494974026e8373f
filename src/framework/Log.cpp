#include "framework/Log.h"

#include <atomic>
#include <cstdio>
#include <memory>
#include <mutex>
#include <streambuf>
#include <vector>

#include "framework/LogBuffer.h"
#include "framework/RepeatLimit.h"
#include "framework/SteadyClock.h"
#include "framework/ThreadObject.h"

namespace plumbline {
namespace {

/// Collects one message in a string that keeps its memory.
class MessageBuffer : public std::streambuf {
public:
  std::string text;

protected:
  int overflow(int c) override {
    if (c != EOF) text.push_back(static_cast<char>(c));
    return c;
  }
  std::streamsize xsputn(const char* data, std::streamsize size) override {
    text.append(data, static_cast<std::size_t>(size));
    return size;
  }
};

struct MessageStream {
  MessageBuffer buffer;
  std::ostream stream{&buffer};
};

/// The streams of a thread: one per message under way, as an operator<< may itself log.
class StreamStack {
public:
  std::ostream& push() {
    if (used_ == streams_.size()) streams_.push_back(std::make_unique<MessageStream>());
    MessageStream& top = *streams_[used_++];
    top.buffer.text.clear();
    top.stream.clear();
    top.stream.flags(std::ios_base::dec | std::ios_base::skipws);
    top.stream.precision(6);
    return top.stream;
  }
  std::string& text() { return streams_[used_ - 1]->buffer.text; }
  void pop() { used_--; }

private:
  std::vector<std::unique_ptr<MessageStream>> streams_;
  std::size_t used_ = 0;
};

StreamStack& streams() {
  static ThreadObject<StreamStack> stacks;
  return stacks.get();
}

std::atomic<bool> hasListener{false};
std::mutex listenerMutex;
std::function<void(std::string_view, std::string_view)>& listener() {
  static std::function<void(std::string_view, std::string_view)> function;
  return function;
}

}  // namespace

LogLine::LogLine(const Log& log, std::string_view start, std::optional<unsigned> keptBack)
    : log_(log), stream_(streams().push()), keptBack_(keptBack) {
  stream_ << start;
}

LogLine::~LogLine() {
  std::string& text = streams().text();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (keptBack_.value_or(0) > 0)
    text += " (" + std::to_string(*keptBack_) + " more like it were not written)";
  if (keptBack_) LogBuffer::instance().add(log_.source(), text);
  streams().pop();
}

LogLine Log::operator<<(std::ostream& (*)(std::ostream&)) { return LogLine(*this, ""); }
LogLine Log::warning(const char* file, int line) { return limited("warning: ", file, line); }
LogLine Log::error(const char* file, int line) { return limited("error: ", file, line); }

LogLine Log::limited(std::string_view start, const char* file, int line) {
  // The clock decides what is written, never what is done.
  static std::mutex mutex;
  static RepeatLimit limit(perSecond, 1024);
  const double now = steadySeconds();
  const std::string kind = source_ + ' ' + file + ':' + std::to_string(line);
  const std::lock_guard lock(mutex);
  return LogLine(*this, start, limit.admit(kind, now));
}

LogBuffer::LogBuffer() : own_(std::make_unique<CrashRecord>()), record_(own_.get()) {}

LogBuffer& LogBuffer::instance() {
  // Never destroyed: modules may log until the very end.
  static LogBuffer* buffer = new LogBuffer;
  return *buffer;
}

void LogBuffer::add(std::string_view source, std::string_view message) {
  record_->add(source, message);
  if (verbose_) {
    std::string line = "[" + std::string(source) + "] " + std::string(message) + "\n";
    std::fwrite(line.data(), 1, line.size(), stdout);
  }
  if (!hasListener) return;
  std::lock_guard lock(listenerMutex);
  if (listener()) listener()(source, message);
}

void LogBuffer::setVerbose(bool verbose) {
  verbose_ = verbose;
  // Line by line, so that everything is out when the agent dies.
  if (verbose) std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

void LogBuffer::trace(std::string_view text) {
  std::string line(text);
  line.push_back('\n');
  std::fwrite(line.data(), 1, line.size(), stdout);
}

void LogBuffer::setListener(std::function<void(std::string_view, std::string_view)> function) {
  std::lock_guard lock(listenerMutex);
  listener() = std::move(function);
  hasListener = listener() != nullptr;
}

void LogBuffer::useRecord(CrashRecord* record) { record_ = record; }

}  // namespace plumbline
