#include "framework/Module.h"

namespace plumbline {

Module::Module() = default;
Module::~Module() = default;

}  // namespace plumbline
