#include "modules/evaluation/OutputProblems.h"

#include <fmt/format.h>

#include <cstdio>

#include "framework/ModuleObjects.h"

namespace plumbline {

MAKE_MODULE_OBJECT(OutputProblems, OutputProblems)

OutputProblems::OutputProblems()
    : OutputProblems([](const std::string& line) { fmt::print(stderr, "{}\n", line); }) {}

void OutputProblems::add(const std::string& problem) {
  any_ = true;
  if (notify_) notify_(problem);
}

}  // namespace plumbline
