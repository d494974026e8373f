#include "gap/diagnosis/MarkDump.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

std::string markOfProgram() {
  MarkDump dump;
  std::ifstream file("/proc/self/exe", std::ios::binary);
  std::array<char, 1 << 16> buffer{};
  while (file.read(buffer.data(), buffer.size()), file.gcount() > 0)
    dump.bytes(buffer.data(), static_cast<std::size_t>(file.gcount()));
  if (!file.eof()) throw std::runtime_error("/proc/self/exe: cannot be read");
  return dump.text();
}

}  // namespace

void MarkDump::addProgram() {
  static const std::string program = markOfProgram();
  add(program);
}

void MarkDump::addLibrary() {
  for (const Effect* effect : effects()) add(std::string(effect->id));
}

std::string MarkDump::text() const {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash_));
  return text;
}

}  // namespace plumbline::gap
