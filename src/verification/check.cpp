#include "boxbeam/verification/check.hpp"

#include <fmt/format.h>

namespace boxbeam {

const char* to_text(Criterion criterion) {
  return criterion == Criterion::yield ? "yield" : "fatigue";
}

std::string to_text(const Station& station) {
  // To a tenth of a millimetre, without trailing zeros.
  std::string s = fmt::format("{:.4f}", station.s.value());
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s + (station.side == Side::both ? "" : to_text(station.side));
}

}  // namespace boxbeam
