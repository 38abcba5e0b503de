#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam::flexible {}  // namespace boxbeam::flexible
