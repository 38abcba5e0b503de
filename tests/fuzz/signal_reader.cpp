// The reader of other programs' signals on any bytes: it hands on finite values of all channels for
// times that ascend, as many as it tells, or says what is wrong. The first byte chooses the format.
#include <cmath>
#include <cstdlib>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/signal_file.hpp"
#include "file_of_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace boxbeam;
  if (size == 0) return 0;
  const fuzz::FileOfBytes file(bytes + 1, size - 1);
  SignalSource source{file.path()};
  // Behind the formats: by content.
  constexpr std::size_t formats = std::size(all_signal_formats);
  if (const std::size_t chosen = bytes[0] % (formats + 1); chosen < formats) {
    source.format = all_signal_formats[chosen];
  }
  if (source.format == SignalFormat::mbdyn || bytes[0] >= 0x80) source.time_step = 0.01;
  // NetCDF is read by libnetcdf and HDF5, which are not ours to fuzz.
  const std::string_view content(reinterpret_cast<const char*>(bytes + 1), size - 1);
  if (source.format == SignalFormat::netcdf || content.starts_with("CDF") ||
      content.starts_with("\x89HDF"))
    return 0;
  std::uint64_t rows = 0;
  double last = 0.0;
  try {
    const std::size_t channels = list_signals(source).channels.size();
    if (channels == 0) std::abort();
    const SignalSummary summary = read_signals(source, {}, [&](const SignalRows& part) {
      if (part.values.size() != channels || part.time.empty()) std::abort();
      for (const double time : part.time) {
        if (!std::isfinite(time) || (rows > 0 && !(time > last))) std::abort();
        last = time;
        ++rows;
      }
      for (const auto& values : part.values) {
        if (values.size() != part.time.size()) std::abort();
        for (const double value : values) {
          if (!std::isfinite(value)) std::abort();
        }
      }
    });
    if (rows == 0 || summary.rows != rows || summary.last_time != last) std::abort();
  } catch (const InputError& error) {
    if (error.problems().empty() || error.problems().front().message.empty()) std::abort();
  }
  return 0;
}
