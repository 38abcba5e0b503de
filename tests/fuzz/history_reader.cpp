// The reader of stress histories on any bytes: it counts finite samples, as many of shear as of
// normal stress, or says what is wrong. The first byte chooses table or raw doubles.
#include <cmath>
#include <cstdlib>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/stress_history.hpp"
#include "file_of_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) return 0;
  const fuzz::FileOfBytes file(bytes + 1, size - 1);
  boxbeam::StressHistorySource source{file.path(), {}};
  if (bytes[0] % 8 == 0) source.binary_unit = "MPa";
  std::uint64_t normal = 0;
  std::uint64_t shear = 0;
  try {
    const boxbeam::StressHistory history =
        boxbeam::read_stress_history(source, [&](const boxbeam::StressSamples& samples) {
          normal += samples.normal.size();
          shear += samples.shear.size();
          for (const auto& values : {samples.normal, samples.shear}) {
            for (const double value : values) {
              if (!std::isfinite(value)) std::abort();
            }
          }
        });
    if (history.samples != normal || (history.has_shear ? shear != normal : shear != 0))
      std::abort();
    if (normal == 0) std::abort();
  } catch (const boxbeam::InputError& error) {
    if (error.problems().empty() || error.problems().front().message.empty()) std::abort();
  }
  return 0;
}
