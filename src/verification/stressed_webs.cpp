#include "stressed_webs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/strength/section_class.hpp"

namespace boxbeam {
namespace {

/// Below this part of its largest stress a plate's compression has no class.
constexpr double negligible = 0.01;

StressedWeb upright(const std::string& name, double y, Length low, Length high, Length thickness,
                    PlateKind kind) {
  return {name, {si<Length>(y), low}, {si<Length>(y), high}, thickness, kind};
}

/// One web where both are stressed alike, which they are in a section that mirrors itself.
std::vector<StressedWeb> webs_in_plane(const Profile& profile, bool alike) {
  const Length low = clear_bottom_of(profile);
  const Length high = clear_top_of(profile);
  if (const auto* box = std::get_if<Box>(&profile)) {
    const double left = (0.5 * box->width - 0.5 * box->left_web).value();
    const double right = (0.5 * box->right_web - 0.5 * box->width).value();
    if (alike) return {upright("web", left, low, high, box->left_web, PlateKind::left_web)};
    return {upright("left web", left, low, high, box->left_web, PlateKind::left_web),
            upright("right web", right, low, high, box->right_web, PlateKind::right_web)};
  }
  if (const auto* tube = std::get_if<RectangularTube>(&profile)) {
    const double left = 0.5 * (tube->width - tube->wall).value();
    if (alike) return {upright("web", left, low, high, tube->wall, PlateKind::wall)};
    return {upright("left web", left, low, high, tube->wall, PlateKind::wall),
            upright("right web", -left, low, high, tube->wall, PlateKind::wall)};
  }
  return {};
}

/// All four plates: under M_z and N the webs are stressed unlike, and the flanges are the webs of
/// V_y.
std::vector<StressedWeb> webs_in_space(const Profile& profile) {
  Box box;
  const bool built = std::holds_alternative<Box>(profile);
  const auto kind = [&](PlateKind of) { return built ? of : PlateKind::wall; };
  if (built)
    box = std::get<Box>(profile);
  else if (const auto* tube = std::get_if<RectangularTube>(&profile))
    box = symmetric_box(tube->width, tube->height, tube->wall, tube->wall);
  else
    return {};
  const Length low = clear_bottom_of(profile), high = clear_top_of(profile);
  const Length left = 0.5 * box.width - box.left_web, right = box.right_web - 0.5 * box.width;
  const Length top = 0.5 * (box.height - box.top_flange);
  const Length bottom = 0.5 * (box.bottom_flange - box.height);
  const double left_middle = 0.5 * (box.width - box.left_web).value();
  const double right_middle = 0.5 * (box.right_web - box.width).value();
  return {
      upright("left web", left_middle, low, high, box.left_web, kind(PlateKind::left_web)),
      upright("right web", right_middle, low, high, box.right_web, kind(PlateKind::right_web)),
      {"top flange", {right, top}, {left, top}, box.top_flange, kind(PlateKind::top_flange), true},
      {"bottom flange",
       {right, bottom},
       {left, bottom},
       box.bottom_flange,
       kind(PlateKind::bottom_flange),
       true}};
}

/// Compression at the ends of a web at an instant [Pa].
struct EndStress {
  double low = 0.0, high = 0.0;
  double most() const { return std::max(low, high); }
};

/// Where between two instants the stress distribution may be the most even one that has a class:
/// the larger compression reaches `least`, or both are equal. Between instants stresses count as
/// linear, so that psi runs one way between these places.
std::array<EndStress, 4> between(const EndStress& a, const EndStress& b, double least) {
  std::array<EndStress, 4> places{b, b, b, b};
  const auto place = [&](std::size_t k, double from, double to) {
    if (from * to >= 0.0) return;
    const double part = from / (from - to);
    places[k] = {a.low + part * (b.low - a.low), a.high + part * (b.high - a.high)};
  };
  place(1, a.low - least, b.low - least);
  place(2, a.high - least, b.high - least);
  place(3, a.low - a.high, b.low - b.high);
  return places;
}

}  // namespace

std::vector<StressedWeb> stressed_webs_of(const Profile& profile, bool in_space, bool alike) {
  return in_space ? webs_in_space(profile) : webs_in_plane(profile, alike);
}

bool webs_are_alike(const Section& section, const PlateMaterials& materials) {
  return is_symmetric_about_z(section) &&
         &materials.of(PlateKind::left_web) == &materials.of(PlateKind::right_web);
}

Class3Limit::Class3Limit(const StrengthDemand& demand, Stress yield, bool member_buckles)
    : per_stress_(demand.gamma_M0 / yield.value()),
      epsilon_(epsilon_of(yield)),
      member_buckles_(member_buckles) {}

double Class3Limit::at(double psi, double design_stress) const {
  const double used = member_buckles_ ? 1.0 : std::min(1.0, per_stress_ * design_stress);
  return internal_part_limits(1.0, psi, epsilon_).class_3 / std::sqrt(used);
}

WorstStress worst_over(const std::vector<SituationHistory>& histories,
                       const StressInfluence& at_low, const StressInfluence& at_high,
                       double required, const Class3Limit& limit) {
  const auto stress_in = [&](const CutForces& cut) {
    return EndStress{-stress_at(at_low, cut).normal.value(),
                     -stress_at(at_high, cut).normal.value()};
  };
  double largest = 0.0;
  for (const SituationHistory& at : histories) {
    for (const CutForces& cut : at.history.samples()) {
      const EndStress stress = stress_in(cut);
      largest = std::max({largest, std::abs(stress.low), std::abs(stress.high)});
    }
  }
  const double least = negligible * largest;
  WorstStress worst;
  for (const SituationHistory& at : histories) {
    const double factor = required * at.situation->load_factor;
    const auto take = [&](const EndStress& stress) {
      constexpr double rounding = 1e-9;
      const double most = stress.most();
      if (most < (1.0 - rounding) * least || most <= 0.0) return;
      const double psi = std::min(stress.low, stress.high) / most;
      const double here = limit.at(psi, factor * most);
      if (worst.limit == 0.0 || here < worst.limit) worst = {psi, factor * most, here};
    };
    const std::vector<CutForces>& samples = at.history.samples();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const EndStress here = stress_in(samples[i]);
      if (at.history.begins_piece(i) || (i == 0 && !at.history.closed())) {
        take(here);
        continue;
      }
      const EndStress before = stress_in(i > 0 ? samples[i - 1] : samples.back());
      for (const EndStress& stress : between(before, here, least)) take(stress);
    }
  }
  return worst;
}

}  // namespace boxbeam
