#include <fmt/chrono.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <string_view>

#include "boxbeam/report/report.hpp"

namespace boxbeam {

std::string report_date() {
  std::time_t time = std::time(nullptr);
  // Source: reproducible-builds.org, SOURCE_DATE_EPOCH: seconds since 1970 in ASCII. What is no
  // number is not followed.
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    const std::string_view text(epoch);
    long long seconds = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    constexpr long long last = 253402300799;  // 9999-12-31
    const bool whole = error == std::errc{} && end == text.data() + text.size();
    if (whole && seconds >= 0 && seconds <= last) time = static_cast<std::time_t>(seconds);
  }
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(time));
}

}  // namespace boxbeam
