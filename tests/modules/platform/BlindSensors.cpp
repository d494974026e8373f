#include "BlindSensors.h"

namespace plumbline {

MAKE_MODULE(BlindSensors)

}  // namespace plumbline
