#include "framework/RepresentationProblem.h"

#include <cmath>
#include <cstring>
#include <vector>

#include "framework/RepresentationLoader.h"

namespace plumbline {
namespace {

/// A float's exponent, all ones in what is not finite.
template <typename Bits>
constexpr Bits exponent = static_cast<Bits>(sizeof(Bits) == 4 ? 0x7f800000 : 0x7ff0000000000000);

/// Eight at a time, without a branch: so the compiler makes vectors of them.
template <typename Bits>
bool allFinite(const void* data, std::size_t count) {
  constexpr std::size_t step = 8;
  const char* at = static_cast<const char*>(data);
  Bits bad = 0, bits[step];
  for (; count >= step; count -= step, at += sizeof bits) {
    std::memcpy(bits, at, sizeof bits);
    Bits found = 0;
    for (std::size_t i = 0; i < step; ++i)
      found |= (bits[i] & exponent<Bits>) == exponent<Bits> ? Bits{1} : Bits{0};
    bad |= found;
  }
  for (; count > 0; count--, at += sizeof(Bits)) {
    std::memcpy(bits, at, sizeof(Bits));
    bad |= (bits[0] & exponent<Bits>) == exponent<Bits> ? Bits{1} : Bits{0};
  }
  return bad == 0;
}

/// Looks at the numbers and writes nothing. Most come by its NumberCheck; what a class writes by its own
/// stream method comes here.
class FiniteCheck final : public OutStream {
public:
  explicit FiniteCheck(NumberCheck& check) : OutStream(check), check_(check) {}

  void writeSigned(std::int64_t, unsigned) override {}
  void writeUnsigned(std::uint64_t, unsigned) override {}
  void writeBool(bool) override {}
  void writeChar(char) override {}
  void writeFloat(float value) override { check_.see(static_cast<double>(value)); }
  void writeDouble(double value) override { check_.see(value); }
  void writeString(std::string_view) override {}
  void writeRaw(const void*, std::size_t) override {}
  void writeBlock(NumberType type, const void* data, std::size_t count) override {
    if (type.kind != NumberType::Kind::floatingPoint || count == 0) return;
    check_.any = true;
    check_.finite &=
        type.bytes == 4 ? allFinite<std::uint32_t>(data, count) : allFinite<std::uint64_t>(data, count);
  }
  void beginObject() override {}
  void endObject() override {}
  void label(std::string_view) override {}
  void beginList(std::size_t, bool) override {}
  void endList() override {}
  bool flat() const override { return true; }

private:
  NumberCheck& check_;
};

/// Finds the first number that is not finite and the labels that lead to it.
class NumberProblem final : public OutStream {
public:
  std::string problem;

  void writeSigned(std::int64_t, unsigned) override { label_.clear(); }
  void writeUnsigned(std::uint64_t, unsigned) override { label_.clear(); }
  void writeBool(bool) override { label_.clear(); }
  void writeChar(char) override { label_.clear(); }
  void writeFloat(float value) override { writeDouble(static_cast<double>(value)); }
  void writeDouble(double value) override {
    if (!std::isfinite(value) && problem.empty())
      report(std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf");
    label_.clear();
  }
  void writeString(std::string_view) override { label_.clear(); }
  void writeRaw(const void*, std::size_t) override { label_.clear(); }
  void beginObject() override {
    open_.push_back(std::move(label_));
    label_.clear();
  }
  void endObject() override { open_.pop_back(); }
  void label(std::string_view name) override { label_ = name; }
  void beginList(std::size_t, bool) override { beginObject(); }
  void endList() override { endObject(); }

private:
  void report(const char* what) {
    open_.push_back(label_);
    for (const std::string& label : open_) {
      if (!label.empty()) problem += (problem.empty() ? "" : ".") + label;
    }
    open_.pop_back();
    problem += (problem.empty() ? "must be finite, not " : ": must be finite, not ") + std::string(what);
  }

  std::vector<std::string> open_;
  std::string label_;
};

/// A representation that writes itself stays as it is.
void writeTo(OutStream& out, const Representation& value) {
  const_cast<Representation&>(value).stream(nullptr, &out);
}

}  // namespace

bool streamsFiniteNumbers(const Representation& value, bool& numbers) {
  NumberCheck check;
  FiniteCheck out(check);
  writeTo(out, value);
  numbers = numbers || check.any;
  return check.finite;
}

std::string numberProblem(const Representation& value) {
  bool numbers = false;
  if (streamsFiniteNumbers(value, numbers)) return {};
  NumberProblem out;
  writeTo(out, value);
  return out.problem;
}

std::string RepresentationLoader::problemOf(const Representation& value) const {
  const std::string problem = numberProblem(value);
  return problem.empty() ? ownProblem(value) : problem;
}

}  // namespace plumbline
