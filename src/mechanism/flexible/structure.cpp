#include "boxbeam/mechanism/flexible/structure.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
