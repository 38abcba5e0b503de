#include "boxbeam/mechanism/flexible/beam_loads.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
