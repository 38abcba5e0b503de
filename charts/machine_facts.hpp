#pragma once

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// What times depend on: the processor, the system, the compiler and whether it optimised.
Facts machine_facts();

}  // namespace boxbeam::report
