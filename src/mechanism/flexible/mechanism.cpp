#include "boxbeam/mechanism/flexible/mechanism.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
