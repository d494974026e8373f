#include "framework/CrashRecord.h"

#include <algorithm>
#include <cstring>

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
  for (std::uint64_t number = end > messages ? end - messages : 1; number < end; number++) {
    const Message& slot = messages_[number % messages];
    if (slot.number.load(std::memory_order_acquire) != number) continue;
    result.append(slot.text.data(), strnlen(slot.text.data(), messageLength));
    result.push_back('\n');
  }
  return result;
}

int CrashRecord::addThread(std::string_view name) {
  const std::uint32_t place = threadCount_.fetch_add(1);
  if (place >= threads) return -1;
  copyText(threads_[place].name.data(), labelLength, name);
  return static_cast<int>(place);
}

std::uint32_t CrashRecord::addStep(std::string_view label) {
  const std::uint32_t place = stepCount_.fetch_add(1);
  if (place >= steps) return 0;
  copyText(steps_[place].data(), labelLength, label);
  return place;
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
  const std::uint32_t count = std::min<std::uint32_t>(threadCount_.load(), threads);
  for (std::uint32_t i = 0; i < count; i++) {
    const char* step = stepOf(static_cast<int>(i));
    result += "[" + std::string(threads_[i].name.data()) + "] ";
    result += step ? step : "between two steps";
    result += static_cast<int>(i) == signalThread.load() ? " <- the signal struck here\n" : "\n";
  }
  return result;
}

}  // namespace plumbline
