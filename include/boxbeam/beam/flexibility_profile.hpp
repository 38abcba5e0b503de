#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/numerics/chebyshev_points.hpp"

namespace boxbeam {

/// Strains of the axis per cut force, rows and columns in the order of cut_force::Index: extension,
/// shear along y and z, twist and the turns about y and z per length. Symmetric.
using Flexibility = Eigen::Matrix<double, 6, 6>;

/// Of a section, K the plane of stress by unsymmetric bending about the axis, e the shear centre,
///
///     (epsilon, kappa_y, kappa_z) = K (N, M_y, M_z)/E
///     gamma_y = V_y/(G A_y) + e_z kappa_T,  gamma_z = V_z/(G A_z) - e_y kappa_T
///     kappa_T = (T + e_z V_y - e_y V_z)/(G I_T)
///
/// kappa_y > 0 lengthens +z, kappa_z > 0 shortens +y. Where the torsion constant of a profile is
/// not known (polygons) it does not twist; `twists` says so. Free warping. SI, moduli in Pa.
/// Source: `normal_stress_plane`, `shear_areas_of`, `torsion_properties_of`; virtual work for the
/// couplings.
Flexibility flexibility_of(const Section& section, double youngs_modulus, double shear_modulus,
                           bool twisted = true);

/// Whether the torsion constant of a section is known.
bool twists(const Section& section);

/// The flexibility along a beam: between neighbouring borders, where nothing jumps, the polynomial
/// through its values at Chebyshev points. A piece is halved until that polynomial is within 1e-12
/// of the largest flexibility of its kind between the points, 1e-10 in twist, down to 2^-16 of a
/// segment: sizes may shrink to 1e-4 of themselves.
class FlexibilityProfile {
 public:
  FlexibilityProfile(const TaperedBeam& beam, double youngs_modulus, double shear_modulus,
                     bool twisted = true);

  /// At a place within the piece from borders()[k] to borders()[k + 1] [m].
  Flexibility at(std::size_t piece, double s) const;

  /// Ascending, from 0 to the beam's length [m].
  const std::vector<double>& borders() const { return borders_; }

  /// Whether nothing changes within the piece from borders()[k] on: of prismatic segments.
  bool is_constant(std::size_t piece) const { return pieces_[piece].constant; }

 private:
  static constexpr std::size_t nodes = 13;
  using Points = ChebyshevPoints<nodes>;

  /// What is not zero at all points: of most sections a few.
  struct Entry {
    Eigen::Index row, column;
    std::array<double, nodes> values;
  };
  struct Piece {
    std::vector<Entry> entries;
    bool constant = false;
  };
  static std::vector<Entry> entries_of(const std::array<Flexibility, nodes>& values);

  void add(const Segment& segment, double from, double to, int halvings);

  double youngs_modulus_, shear_modulus_;
  bool twisted_;
  std::vector<double> borders_{0.0};
  std::vector<Piece> pieces_;
};

}  // namespace boxbeam
