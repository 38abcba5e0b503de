#include "boxbeam/project/project.hpp"

namespace boxbeam {}  // namespace boxbeam
