#include "framework/CrashRecord.h"

#include <algorithm>
#include <cstring>
#include <mutex>

namespace plumbline {
namespace {

void copyText(char* target, std::size_t size, std::string_view text) {
  const std::size_t length = std::min(text.size(), size - 1);
  std::memcpy(target, text.data(), length);
  target[length] = 0;
}

thread_local int placeOfThread = -1;

}  // namespace

void CrashRecord::add(std::string_view source, std::string_view message) {
  const std::uint64_t number = next_.fetch_add(1, std::memory_order_relaxed);
  Message& slot = messages_[number % messages];
  // Two writers meet in a slot only if one sleeps through a whole round of the ring: the text may then be a
  // mixture, but it always ends within the slot.
  slot.number.store(0, std::memory_order_release);
  char* text = slot.text.data();
  std::size_t used = 0;
  const auto append = [&](std::string_view part) {
    const std::size_t length = std::min(part.size(), messageLength - 1 - used);
    std::memcpy(text + used, part.data(), length);
    used += length;
  };
  append("[");
  append(source.substr(0, labelLength));
  append("] ");
  append(message);
  text[used] = 0;
  slot.number.store(number, std::memory_order_release);
}

std::string CrashRecord::lastMessages() const {
  const std::uint64_t end = next_.load(std::memory_order_acquire);
  std::string result;
  for (std::uint64_t number = end > messages ? end - messages : 1; number < end; ++number) {
    const Message& slot = messages_[number % messages];
    if (slot.number.load(std::memory_order_acquire) != number) continue;
    result.append(slot.text.data(), strnlen(slot.text.data(), messageLength));
    result.push_back('\n');
  }
  return result;
}

int CrashRecord::addThread(std::string_view name) {
  for (std::size_t i = 0; i < threads; ++i) {
    if (threads_[i].taken.exchange(true)) continue;
    threads_[i].step = 0;
    copyText(threads_[i].name.data(), labelLength, name);
    return static_cast<int>(i);
  }
  return -1;
}

void CrashRecord::removeThread(int thread) {
  if (thread >= 0) threads_[static_cast<std::size_t>(thread)].taken = false;
}

std::uint32_t CrashRecord::addStep(std::string_view label) {
  static std::mutex mutex;
  std::lock_guard lock(mutex);
  label = label.substr(0, labelLength - 1);
  const std::uint32_t count = std::min<std::uint32_t>(stepCount_, steps);
  for (std::uint32_t i = 1; i < count; ++i) {
    if (label == steps_[i].data()) return i;
  }
  if (count == steps) return 0;
  copyText(steps_[count].data(), labelLength, label);
  stepCount_ = count + 1;
  return count;
}

void CrashRecord::enterThread(int thread) { placeOfThread = thread; }
int CrashRecord::currentThread() { return placeOfThread; }

const char* CrashRecord::stepOf(int thread) const {
  if (thread < 0 || thread >= static_cast<int>(threads)) return nullptr;
  const std::uint32_t step = threads_[static_cast<std::size_t>(thread)].step.load();
  return step == 0 || step >= steps ? nullptr : steps_[step].data();
}

std::string CrashRecord::whereabouts() const {
  std::string result;
  for (std::size_t i = 0; i < threads; ++i) {
    if (!threads_[i].taken) continue;
    const char* step = stepOf(static_cast<int>(i));
    result += "[" + std::string(threads_[i].name.data()) + "] ";
    result += step ? step : "between two steps";
    result += static_cast<int>(i) == signalThread.load() ? " <- the signal struck here\n" : "\n";
  }
  return result;
}

CrashPlace::CrashPlace(CrashRecord& record, std::string_view threadName)
    : record_(record), before_(CrashRecord::currentThread()), thread_(record.addThread(threadName)) {
  CrashRecord::enterThread(thread_);
}

CrashPlace::~CrashPlace() {
  CrashRecord::enterThread(before_);
  record_.removeThread(thread_);
}

}  // namespace plumbline
