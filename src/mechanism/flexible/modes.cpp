#include "boxbeam/mechanism/flexible/modes.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
