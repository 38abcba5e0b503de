#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/strength/weld_throat.hpp"
#include "patch_search.hpp"

namespace boxbeam {
namespace {

/// How much a throat is used by forces per length, of legs alike.
double use_of(Stress across, Stress along, Length throat, const WeldStrength& strength) {
  const WeldForce force{across * throat, {}, along * throat};
  return directional_utilisation(throat_stress_of(force, throat), strength).largest();
}

}  // namespace

bool joins(const StressPoint& throat, BoxPlate plate) {
  using enum BoxPlate;
  return plate == (throat.z.value() > 0.0 ? top_flange : bottom_flange) ||
         plate == (throat.y.value() > 0.0 ? left_web : right_web);
}

PatchSearch::Spread PatchSearch::spread_of(const Patch& patch, const PatchedWeb& web) const {
  // Beside a piece of a load along the beam there is more of it.
  const Length half = 0.5 * (patch.is_line ? patch.stiff_length : loaded_length_of(web));
  const Length end = project_->beam.length();
  // A diaphragm at an end takes what would lie beyond it.
  const auto takes = [&](Length at) {
    const Diaphragm* const of = diaphragm_at(at);
    return of != nullptr && holds(*of, patch.along_z);
  };
  Spread of{patch.s - half, patch.s + half};
  if (of.from < Length{} && !takes(Length{})) of.from = Length{};
  if (of.to > end && !takes(end)) of.to = end;
  return of;
}

std::vector<PressedWeb> PatchSearch::pressed_by(const Patch& patch) {
  std::vector<PressedWeb> pressed;
  if (patch.diaphragm != nullptr) return pressed;
  for (const Reached& reached : reached_by(patch)) {
    const JudgedSection& judged = judged_at(reached.at);
    if (!judged.box) continue;
    const auto [webs, shares] = shared_by_webs(patch, judged.box->box());
    for (const std::size_t k : {0U, 1U}) {
      // It may push at the one flange or pull at the other.
      for (const BoxPlate flange : flanges_of(patch)) {
        const PatchedWeb web = web_of(judged, webs[k], flange, patch);
        const Spread spread = spread_of(patch, web);
        const PressedWeb of{webs[k],
                            shares[k] * patch.force / (web.thickness * (spread.to - spread.from)),
                            patch.s - spread.from, spread.to - patch.s, patch.stiff_length};
        const auto same =
            std::find_if(pressed.begin(), pressed.end(),
                         [&](const PressedWeb& other) { return other.plate == of.plate; });
        if (same == pressed.end())
          pressed.push_back(of);
        else if (abs(of.stress) > abs(same->stress))
          *same = of;
      }
    }
  }
  return pressed;
}

std::vector<Borne> PatchSearch::seams_at(const Patch& patch, const std::vector<Patch>& all,
                                         const JudgedSection& judged, const CutForces& cut) const {
  // What a diaphragm takes goes through its own welds; several are judged where they meet.
  std::vector<Borne> ways;
  if (judged.seams.empty() || patch.diaphragm != nullptr || patch.together) return ways;
  const FourWalls& walls = judged.box->box();
  const auto [webs, shares] = shared_by_webs(patch, walls);
  Borne of;
  of.part = Borne::Part::weld;
  PatchBasis& basis = of.basis;
  basis.force = abs(patch.force);
  basis.box = judged.box;
  basis.cut = cut;
  for (const std::size_t k : {0U, 1U}) {
    basis.share = std::abs(shares[k]);
    if (!(basis.share > 0.0)) continue;
    const BoxPlate web = webs[k];
    of.plate = web;
    for (const BoxPlate flange : flanges_of(patch)) {
      const auto throat =
          std::find_if(judged.seams.begin(), judged.seams.end(),
                       [&](const auto& at) { return joins(*at, web) && joins(*at, flange); });
      if (throat == judged.seams.end()) continue;
      const PlateOf& joined = (*throat)->joined;
      const auto tensile = tensile_strength_of(*joined.material, joined.thickness);
      if (!tensile) continue;
      const Length a = seam_throat_of(**throat);
      const auto spread = [&](const Patch& at) {
        return spread_of(at, web_of(judged, web, flange, at));
      };
      const Spread own = spread(patch);
      PatchedSeam seam{*throat,
                       flange,
                       own.to - own.from,
                       {},
                       {*tensile, joined.material->beta_w, project_->strength.gamma_M2}};
      // Of a load along the beam there are copies at many places: it counts once.
      std::array<Stress, 2> along_beam{};  // of the same axis, and square to it
      for (const Patch& other : all) {
        if (&other == &patch || other.together || other.diaphragm != nullptr) continue;
        // What comes in square to it puts as much into the throat at the worst, of either sense;
        // of a torque, which stands for both, once.
        const bool square = other.along_z != patch.along_z;
        if (square ? other.is_torque() && other.force < Force{}
                   : (other.is_line && patch.is_line) ||
                         (other.force > Force{}) != (patch.force > Force{}))
          continue;
        const Spread its =
            square ? spread_of(other, web_of(judged, flange, web, other)) : spread(other);
        if (!(its.from < own.to && its.to > own.from)) continue;
        const Shared shared = shared_by_webs(other, walls);
        const std::size_t part = square ? (shared.webs[0] == flange ? 0 : 1) : k;
        const Stress beside =
            std::abs(shared.shares[part]) * abs(other.force) / ((its.to - its.from) * a);
        if (other.is_line)
          along_beam[square ? 1 : 0] = std::max(along_beam[square ? 1 : 0], beside);
        else
          seam.beside += beside;
      }
      seam.beside += along_beam[0] + along_beam[1];
      const Force acting = basis.share * basis.force;
      const Stress across = acting / (seam.loaded * a) + seam.beside;
      const Stress along = stress_at((*throat)->influence, cut).shear;
      basis.resistance = acting / use_of(across, along, a, seam.strength);
      basis.bears = std::move(seam);
      ways.push_back(of);
    }
  }
  return ways;
}

}  // namespace boxbeam
