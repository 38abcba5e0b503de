#include "boxbeam/verification/check.hpp"

#include <fmt/format.h>

namespace boxbeam {

const char* to_text(Criterion criterion) {
  switch (criterion) {
    case Criterion::yield: return "yield";
    case Criterion::fatigue: return "fatigue";
    case Criterion::shear_fatigue: return "shear fatigue";
    case Criterion::combined_fatigue: return "combined fatigue";
    case Criterion::stress_range: return "stress range";
    case Criterion::weld: return "weld";
    case Criterion::effective_section: return "effective section";
    case Criterion::shear_buckling: return "shear buckling";
    case Criterion::interaction: return "interaction";
    case Criterion::reduced_stress: return "reduced stress";
    case Criterion::patch_loading: return "patch loading";
    case Criterion::patch_fatigue: return "patch fatigue";
    case Criterion::distortion: return "distortion";
    case Criterion::distortion_fatigue: return "distortion fatigue";
    case Criterion::member: return "member buckling";
    case Criterion::pin: return "pin";
    case Criterion::lug_fatigue: return "lug fatigue";
    case Criterion::rod: return "rod";
    case Criterion::buckling: return "buckling";
    case Criterion::deflection: return "deflection";
  }
  return "";
}

std::string to_text(const Station& station) {
  // To a tenth of a millimetre, without trailing zeros.
  std::string s = fmt::format("{:.4f}", station.s.value());
  s.erase(s.find_last_not_of('0') + 1);
  if (s.back() == '.') s.pop_back();
  return s + (station.side == Side::both ? "" : to_text(station.side));
}

}  // namespace boxbeam
