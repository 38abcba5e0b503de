#include "boxbeam/core/error.hpp"
#include "program/chart_command.hpp"

/// The charts are a library of their own, which a build may leave out.
namespace boxbeam::program {

std::vector<std::string> chart_topics() { return {}; }

int run_chart(const ChartOptions&) {
  throw InputError("this build of boxbeam has no charts",
                   "configure it with cmake -DBOXBEAM_CHARTS=ON, as scripts/test.sh does");
}

}  // namespace boxbeam::program
