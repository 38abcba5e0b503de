#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {}  // namespace boxbeam
