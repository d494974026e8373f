#pragma once
#include <string>

namespace plumbline::training {

/// A page in Markdown of the search tasks that are linked into the program, with the options of each.
std::string taskPage();

}  // namespace plumbline::training
