#include "boxbeam/mechanism/flexible/matrices.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
