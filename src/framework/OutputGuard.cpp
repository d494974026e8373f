#include "framework/OutputGuard.h"

#include <cmath>

namespace plumbline {

namespace {

/// Looks at the numbers and writes nothing.
class FiniteCheck final : public OutStream {
public:
  bool finite = true, numbers = false;

  void writeSigned(std::int64_t, unsigned) override {}
  void writeUnsigned(std::uint64_t, unsigned) override {}
  void writeBool(bool) override {}
  void writeChar(char) override {}
  void writeFloat(float value) override { see(static_cast<double>(value)); }
  void writeDouble(double value) override { see(value); }
  void writeString(std::string_view) override {}
  void writeRaw(const void*, std::size_t) override {}
  void beginObject() override {}
  void endObject() override {}
  void label(std::string_view) override {}
  void beginList(std::size_t, bool) override {}
  void endList() override {}

private:
  void see(double value) {
    numbers = true;
    finite = finite && std::isfinite(value);
  }
};

}  // namespace

bool streamsFiniteNumbers(Representation& value, bool& numbers) {
  FiniteCheck check;
  value.stream(nullptr, &check);
  numbers = numbers || check.numbers;
  return check.finite;
}

OutputGuard::OutputGuard(const RepresentationLoader& loader, Representation& value)
    : loader_(&loader), value_(&value), lastGood_(loader.create()) {
  loader.copy(value, lastGood_->get());
}

bool OutputGuard::accept() {
  if (!streamsFiniteNumbers(*value_, numbers_)) {
    loader_->copy(lastGood_->get(), *value_);
    return false;
  }
  if (numbers_) loader_->copy(*value_, lastGood_->get());
  return true;
}

}  // namespace plumbline
