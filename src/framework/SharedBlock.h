#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <utility>
#include <vector>

#include "framework/StreamTypes.h"

namespace plumbline {

/// A list of numbers that its copies share, for what is large (pictures, maps): a copy costs the same
/// whatever the length. A change of one copy does not change the others. Copies may be read, changed and
/// destroyed in different threads; one copy belongs to one thread at a time. Streams like a std::vector.
template <BlockNumber T>
class SharedBlock {
public:
  SharedBlock() = default;
  explicit SharedBlock(std::size_t size, T value = {}) { std::ranges::fill(renew(size), value); }
  /// A copy shares the numbers, and starts without memory of its own to use again.
  SharedBlock(const SharedBlock& other) : shared_(other.shared_) {}
  SharedBlock& operator=(const SharedBlock& other) {
    shared_ = other.shared_;
    return *this;
  }
  SharedBlock(SharedBlock&&) noexcept = default;
  SharedBlock& operator=(SharedBlock&&) noexcept = default;
  ~SharedBlock() = default;

  std::size_t size() const { return values().size(); }
  bool empty() const { return values().empty(); }
  const T& operator[](std::size_t i) const { return values()[i]; }
  auto begin() const { return values().begin(); }
  auto end() const { return values().end(); }
  /// Valid until this object changes.
  std::span<const T> values() const { return shared_.values(); }

  /// The numbers, to be changed; copied first if another object shares them.
  std::span<T> edit() {
    if (shared_.alone()) return shared_.change();
    const Counted before = shared_;
    const std::span<T> result = renew(before.values().size());
    std::ranges::copy(before.values(), result.begin());
    return result;
  }

  /// `size` numbers of any value, to be overwritten. Memory that this object used before is reused once
  /// nobody shares it: a block that is renewed in each cycle soon needs no new memory, which the system would
  /// have to clear first.
  std::span<T> renew(std::size_t size) {
    if (!shared_.alone()) {
      auto spare = std::ranges::find_if(spares_, &Counted::alone);
      if (spare == spares_.end()) {
        std::ranges::rotate(spares_, spares_.end() - 1);  // the one kept for longest goes
        spare = spares_.begin();
        *spare = Counted::make();
      }
      std::swap(*spare, shared_);
    }
    shared_.resize(size);
    return shared_.change();
  }

  friend bool operator==(const SharedBlock& a, const SharedBlock& b) {
    return std::ranges::equal(a.values(), b.values());
  }

private:
  /// A vector together with the number of those who hold it. Not std::shared_ptr, whose use_count() does not
  /// say that another thread has finished reading.
  class Counted {
  public:
    Counted() = default;
    static Counted make() {
      Counted result;
      result.memory_ = new Memory;
      return result;
    }
    Counted(const Counted& other) : memory_(other.memory_) {
      if (memory_) memory_->owners.fetch_add(1, std::memory_order_relaxed);
    }
    Counted(Counted&& other) noexcept : memory_(std::exchange(other.memory_, nullptr)) {}
    Counted& operator=(Counted other) noexcept {
      std::swap(memory_, other.memory_);
      return *this;
    }
    ~Counted() {
      if (memory_ && memory_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete memory_;
    }

    /// Nobody else holds it, nor will while the caller does not copy it.
    bool alone() const { return memory_ && memory_->owners.load(std::memory_order_acquire) == 1; }
    std::span<const T> values() const {
      return memory_ ? std::span<const T>(memory_->numbers) : std::span<const T>();
    }
    std::span<T> change() { return memory_->numbers; }
    void resize(std::size_t size) { memory_->numbers.resize(size); }

  private:
    struct Memory {
      std::atomic<std::size_t> owners{1};
      std::vector<T> numbers;
    };
    Memory* memory_ = nullptr;
  };

  /// More than the places that a value has on its way from one thread to another.
  static constexpr std::size_t maxSpares = 8;
  Counted shared_;
  std::array<Counted, maxSpares> spares_;
};

template <typename T>
struct StreamType<SharedBlock<T>> {
  static void write(OutStream& out, const SharedBlock<T>& value) {
    out.beginList(value.size(), true);
    out.writeBlock(numberType<T>(), value.values().data(), value.size());
    out.endList();
  }
  static void read(InStream& in, SharedBlock<T>& value) {
    in.beginList();
    if (const auto count = in.blockAhead(numberType<T>())) {
      in.readBlock(numberType<T>(), value.renew(*count).data(), *count);
      return in.endList();
    }
    std::vector<T> numbers;
    while (in.nextElement()) {
      T number{};
      StreamType<T>::read(in, number);
      if (!in.ok()) return;
      numbers.push_back(number);
    }
    in.endList();
    if (in.ok()) std::ranges::copy(numbers, value.renew(numbers.size()).begin());
  }
};

}  // namespace plumbline
