#include "boxbeam/verification/check.hpp"

#include <fmt/format.h>

namespace boxbeam {

const char* to_text(Criterion criterion) {
  return criterion == Criterion::yield ? "yield" : "fatigue";
}

std::string to_text(const Station& station) {
  return fmt::format("{:.4g}{}", station.s.value(),
                     station.side == Side::both ? "" : to_text(station.side));
}

}  // namespace boxbeam
