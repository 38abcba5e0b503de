#include "boxbeam/mechanism/flexible/response.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
