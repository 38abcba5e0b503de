// The reader of cases on any text: a case, or all that is wrong with it, each with words.
#include <cstdlib>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/project.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(bytes), size);
  try {
    const boxbeam::Project project = boxbeam::parse_project("case.toml", text);
    if (project.situations.empty() || !(project.beam.length().value() > 0.0)) std::abort();
  } catch (const boxbeam::InputError& error) {
    if (error.problems().empty()) std::abort();
    for (const boxbeam::Problem& problem : error.problems()) {
      if (problem.message.empty()) std::abort();
    }
  }
  return 0;
}
