#pragma once
#include <string>

#include "field/FieldSize.h"

namespace plumbline {

class ConfigSection;

/// The sizes that a part of a configuration names; all others are the league's. Throws ConfigurationError,
/// one line with file, line and key, for a size that cannot be.
FieldSize readFieldSize(const ConfigSection& section);

/// The same of a file like config/field.yaml, in which a key that there is not is an error as well.
FieldSize readFieldFile(const std::string& path);

}  // namespace plumbline
