#pragma once
#include <string>

namespace plumbline {

/// A text in double quotes as YAML reads it; control characters become blanks.
std::string yamlText(const std::string& text);

}  // namespace plumbline
