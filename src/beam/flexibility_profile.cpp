#include "boxbeam/beam/flexibility_profile.hpp"

#include <algorithm>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "boxbeam/section/torsion.hpp"

namespace boxbeam {

Flexibility flexibility_of(const Section& section, double youngs_modulus, double shear_modulus,
                           bool twisted) {
  using namespace cut_force;
  Flexibility of = Flexibility::Zero();
  // The plane a + b y + c z of stress: extension a, turn about y c, about z -b.
  const Eigen::Matrix3d plane = normal_stress_plane(sums_of(outline_of(section, {})));
  const std::array<Eigen::Index, 3> bends{N, M_y, M_z};
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Index force = bends[static_cast<std::size_t>(k)];
    of(N, force) = plane(0, k) / youngs_modulus;
    of(M_y, force) = plane(2, k) / youngs_modulus;
    of(M_z, force) = -plane(1, k) / youngs_modulus;
  }
  const ShearAreas areas = shear_areas_of(section);
  of(V_y, V_y) = 1.0 / (shear_modulus * areas.y.value());
  of(V_z, V_z) = 1.0 / (shear_modulus * areas.z.value());
  if (!twisted) return of;
  const TorsionProperties torsion = torsion_properties_of(section);
  if (!torsion.I_T) return of;
  Eigen::Matrix<double, 6, 1> torque = Eigen::Matrix<double, 6, 1>::Unit(T);
  if (torsion.shear_centre) {
    torque[V_y] = torsion.shear_centre->z.value();
    torque[V_z] = -torsion.shear_centre->y.value();
  }
  of += torque * torque.transpose() / (shear_modulus * torsion.I_T->value());
  return of;
}

bool twists(const Section& section) { return torsion_constant_of(section).has_value(); }

FlexibilityProfile::FlexibilityProfile(const TaperedBeam& beam, double youngs_modulus,
                                       double shear_modulus, bool twisted)
    : youngs_modulus_(youngs_modulus), shear_modulus_(shear_modulus), twisted_(twisted) {
  for (const Segment& segment : beam.segments)
    add(segment, segment.start.value(), segment.end().value(), 0);
}

void FlexibilityProfile::add(const Segment& of, double from, double to, int halvings) {
  // From the nearer end, so that near a thin one no digits are lost.
  const auto exact = [&](double s) {
    const double before = std::max(0.0, (s - of.start.value()) / of.length.value());
    const double behind = std::max(0.0, (of.end().value() - s) / of.length.value());
    return flexibility_of(before <= behind ? interpolate(of.from, of.to, before)
                                           : interpolate(of.to, of.from, behind),
                          youngs_modulus_, shear_modulus_, twisted_);
  };
  std::array<Flexibility, nodes> values;
  const bool prismatic = of.from == of.to;
  for (std::size_t k = 0; k < nodes; ++k) {
    values[k] = prismatic && k > 0 ? values[0] : exact(Points::between(from, to, k));
  }
  borders_.push_back(to);
  pieces_.push_back({entries_of(values), prismatic});
  // The torsion constant of a box bends where the table of its corners has an entry.
  Flexibility within = Flexibility::Constant(1e-12);
  within.row(cut_force::T).setConstant(1e-10);
  within.col(cut_force::T).setConstant(1e-10);
  constexpr int most_halvings = 16;
  if (prismatic || halvings == most_halvings) return;
  Flexibility largest = Flexibility::Zero();
  for (const Flexibility& value : values) largest = largest.cwiseMax(value.cwiseAbs());
  for (std::size_t k = 0; k + 1 < nodes; ++k) {
    const double s = 0.5 * (Points::between(from, to, k) + Points::between(from, to, k + 1));
    const Flexibility missed = (at(pieces_.size() - 1, s) - exact(s)).cwiseAbs();
    // What couples two cut forces by round-off is measured by what each does alone.
    const Eigen::Array<double, 6, 1> size = largest.diagonal().array().sqrt();
    const bool close =
        (missed.array() <= within.array() * (size.matrix() * size.matrix().transpose()).array())
            .all();
    if (close) continue;
    borders_.pop_back();
    pieces_.pop_back();
    const double middle = 0.5 * (from + to);
    add(of, from, middle, halvings + 1);
    add(of, middle, to, halvings + 1);
    return;
  }
}

std::vector<FlexibilityProfile::Entry> FlexibilityProfile::entries_of(
    const std::array<Flexibility, nodes>& values) {
  std::vector<Entry> entries;
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = 0; column < 6; ++column) {
      Entry entry{row, column, {}};
      bool any = false;
      for (std::size_t k = 0; k < nodes; ++k) {
        entry.values[k] = values[k](row, column);
        any = any || entry.values[k] != 0.0;
      }
      if (any) entries.push_back(entry);
    }
  }
  return entries;
}

Flexibility FlexibilityProfile::at(std::size_t piece, double s) const {
  Flexibility of = Flexibility::Zero();
  if (is_constant(piece)) {
    for (const Entry& entry : pieces_[piece].entries)
      of(entry.row, entry.column) = entry.values.front();
    return of;
  }
  const double from = borders_[piece], to = borders_[piece + 1];
  const Points::Shares shares = Points::shares_at((2.0 * s - from - to) / (to - from));
  for (const Entry& entry : pieces_[piece].entries) {
    double sum = 0.0;
    for (std::size_t k = 0; k < nodes; ++k) sum += shares.weights[k] * entry.values[k];
    of(entry.row, entry.column) = sum / shares.sum;
  }
  return of;
}

}  // namespace boxbeam
