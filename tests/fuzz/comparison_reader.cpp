// The reader of published values on any bytes: rows with finite values and tolerances, or all that
// is wrong, each with a line of the file.
#include <cmath>
#include <cstdlib>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/published_values.hpp"
#include "file_of_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::FileOfBytes file(bytes, size);
  try {
    const boxbeam::PublishedValues values = boxbeam::read_published(file.path());
    if (values.rows.empty()) std::abort();
    for (const boxbeam::PublishedValue& row : values.rows) {
      if (row.key.empty() || row.line <= 0) std::abort();
      if (!std::isfinite(row.value.value) || !(row.tolerance.value >= 0.0)) std::abort();
    }
  } catch (const boxbeam::InputError& error) {
    if (error.problems().empty()) std::abort();
    for (const boxbeam::Problem& problem : error.problems()) {
      if (problem.message.empty()) std::abort();
    }
  }
  return 0;
}
