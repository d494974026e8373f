#pragma once
#include <string>

#include "record/LogReader.h"

namespace plumbline::logtool {

/// What is in a log, for people: threads with their cycles and time, and each representation with who
/// provided it, how many messages it has and how large they are.
std::string listing(record::LogReader& log);

}  // namespace plumbline::logtool
