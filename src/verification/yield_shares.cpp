#include "yield_shares.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "boxbeam/project/plate_material.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/material.hpp"

namespace boxbeam {

YieldShares::YieldShares(const Project& project, std::vector<ComparedPlace> places)
    : project_(&project), places_(std::move(places)) {
  const TaperedBeam& beam = project.beam;
  std::optional<Section> last;
  std::array<std::size_t, 2> last_segments{};
  for (const ComparedPlace& place : places_) {
    const Length s = place.station.s;
    Section section = section_at(beam, place.station);
    const std::array segments{segment_at(beam, {s, Side::before}),
                              segment_at(beam, {s, Side::behind})};
    // As at the place before where it goes on.
    const bool goes_on = last && segments == last_segments && section == *last;
    strengths_.push_back(goes_on ? strengths_.back() : strength_of(section, s));
    last = std::move(section);
    last_segments = segments;
  }
}

/// The corners of a section in which N, off its centroid, or bending about axes that are not the
/// principal ones makes more stress than M/W tells; none of a section in which neither is so.
std::vector<YieldShares::ExcessPoint> YieldShares::excess_points_of(const Section& section) {
  const Outline border = outline_of(section, {});
  const AreaSums sums = sums_of(border);
  const double size = std::sqrt(sums.area);
  constexpr double round_off = 1e-9;
  const bool alike = std::abs(sums.y) + std::abs(sums.z) < round_off * sums.area * size &&
                     std::abs(sums.yz) < round_off * std::max(sums.yy, sums.zz);
  std::vector<ExcessPoint> points;
  if (alike) return points;
  for (const BorderPiece& piece : border) {
    const StressInfluence of = normal_influence(sums, piece.from.x(), piece.from.y());
    points.push_back({of.normal[cut_force::N] - 1.0 / sums.area, of.normal[cut_force::M_y],
                      of.normal[cut_force::M_z]});
  }
  return points;
}

YieldShares::Strength YieldShares::strength_of(const Section& section, Length s) const {
  const Length half = 0.5 * height_of(section.outer);
  const Length wall = std::max(wall_at(section.outer, half), wall_at(section.outer, -half));
  const PlateOf first = first_to_yield(plates_around(*project_, s, wall));
  const auto yield = yield_strength_of(*first.material, wall);
  return {yield ? yield->value() : std::numeric_limits<double>::infinity(),
          properties_of(section).W_z.value(), excess_points_of(section)};
}

template <class Use>
double YieldShares::largest(const CutForceDiagram& diagram, const Use& use) const {
  double most = 0.0;
  for (std::size_t k = 0; k < places_.size(); ++k)
    most = std::max(most, use(places_[k], strengths_[k], diagram.at(places_[k].station)));
  return most;
}

double YieldShares::compression(const CutForceDiagram& diagram) const {
  return largest(diagram, [](const ComparedPlace& place, const Strength& of, const CutForces& cut) {
    return -cut.N.value() * place.per_N / of.yield;
  });
}

double YieldShares::bending(const CutForceDiagram& diagram) const {
  return largest(diagram, [](const ComparedPlace& place, const Strength& of, const CutForces& cut) {
    return std::abs(cut.M_y.value()) * place.per_M / of.yield;
  });
}

double YieldShares::bending_across(const CutForceDiagram& diagram) const {
  return largest(diagram, [](const ComparedPlace&, const Strength& of, const CutForces& cut) {
    return std::abs(cut.M_z.value()) / (of.modulus_across * of.yield);
  });
}

double YieldShares::excess(const CutForceDiagram& diagram) const {
  return largest(
      diagram, [&](const ComparedPlace& place, const Strength& of, const CutForces& cut) {
        if (of.excess.empty()) return 0.0;
        const double N = cut.N.value(), M_y = cut.M_y.value(), M_z = cut.M_z.value();
        double full = 0.0;
        for (const ExcessPoint& at : of.excess)
          full = std::max(full, std::abs(at[0] * N + at[1] * M_y + at[2] * M_z));
        const double plain = std::abs(M_y) * place.per_M +
                             (project_->in_space ? std::abs(M_z) / of.modulus_across : 0.0);
        return (full - plain) / of.yield;
      });
}

double YieldShares::bending(const Compared& of, double factor) const {
  const Eigen::MatrixXd bent = of.straight + of.change;
  if (bent.rows() == 0) return 0.0;
  double most = 0.0;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    // Half the difference of the two fibres is M/W.
    const auto i = 2 * static_cast<Eigen::Index>(k);
    const double bending = 0.5 * (bent.col(i) - bent.col(i + 1)).cwiseAbs().maxCoeff();
    most = std::max(most, factor * bending / strengths_[k].yield);
  }
  return most;
}

Compared YieldShares::with_modulus_across(Compared of) const {
  for (Eigen::MatrixXd* const stresses : {&of.straight, &of.change}) {
    if (stresses->rows() == 0) continue;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const auto i = 2 * static_cast<Eigen::Index>(k);
      const Eigen::VectorXd axial = 0.5 * (stresses->col(i) + stresses->col(i + 1));
      const Eigen::VectorXd bending = 0.5 * (stresses->col(i) - stresses->col(i + 1)) /
                                      (strengths_[k].modulus_across * places_[k].per_M);
      stresses->col(i) = axial + bending;
      stresses->col(i + 1) = axial - bending;
    }
  }
  return of;
}

}  // namespace boxbeam
