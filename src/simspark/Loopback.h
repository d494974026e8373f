#pragma once
#include "framework/Loopback.h"

namespace plumbline::simspark {

using plumbline::isLoopbackAddress;
using plumbline::sameSecret;

}  // namespace plumbline::simspark
