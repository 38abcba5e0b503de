#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/section/cut_forces.hpp"
#include "boxbeam/section/plate_kind.hpp"
#include "boxbeam/section/section.hpp"

/// Stresses of boxes, tubes and plates by formulas of its own, for the oracle: rectangles summed
/// and Navier's plane solved as a system of three equations, shear flow by walking once round the
/// ring of walls, Bredt's flow, Prandtl's series. From the library come only the dimensions of a
/// section (interpolated between two) and the torsion constant of a welded box, whose corners are a
/// finite-element solution.
namespace oracle {

/// Stress per cut force [1/m^2, 1/m^3], in the order of cut_force::Index.
using Factors = std::array<double, boxbeam::cut_force::count>;

/// What a place in a section is, for the rules of what resists there.
enum class PlaceKind {
  fibre,   ///< a plate at the outermost fibres, its corners, a round wall, a stiffener
  web,     ///< a web between its ends, a hole in it
  seam,    ///< where a web is welded to a flange
  throat,  ///< the weld of a seam: shear alone
};

/// A place in a section and its stress per cut force.
struct Place {
  std::string name;
  PlaceKind kind = PlaceKind::fibre;
  double y = 0.0, z = 0.0;
  double plate = 0.0;  ///< thickness [m]; of a throat, of the web
  Factors normal{}, shear{};
  std::string hole;      ///< on the edge of this one
  double joined = 0.0;   ///< of a throat: the thicker of the plates that it joins
  bool at_flat = false;  ///< a stiffener is welded on there
  /// The plate it is in, and what that is welded to where the place is an end of it.
  boxbeam::PlateKind wall = boxbeam::PlateKind::wall;
  std::optional<boxbeam::PlateKind> beside = {};
  double beside_plate = 0.0;  ///< its thickness [m]
};

/// A section seen from one side of a station, with two more of its segment for derivatives.
struct LocalSection {
  boxbeam::Section here;
  std::vector<boxbeam::Hole> holes;
  /// Sections nearby and their weights in d/ds; empty where the segment is prismatic.
  std::vector<std::pair<boxbeam::Section, double>> nearby;
  bool space = false;  ///< places on the outer faces; else webs of symmetric sections at mid-line
  double flange_part = 1.0, web_part = 1.0;  ///< what shear lag leaves of the clear widths
};

/// Whether the formulas cover a section: boxes and sharp rectangular tubes, round tubes, each with
/// another of them inside or none, and single plates.
bool covers(const boxbeam::Section& section);

/// About `around` places on all walls of a section, corners, seams and stiffeners among them.
std::vector<Place> places_of(const LocalSection& section, int around);

/// What is needed for the edge of a hole in one wall: stress at its centre in the gross section,
/// and the gradient of the normal stress along the wall, of N in the gross section, of the moments
/// in the net one.
struct HoleCentre {
  std::string wall;
  double y = 0.0, z = 0.0;
  double plate = 0.0;
  bool along_z = true;  ///< the wall runs along z (a web)
  double clear = 0.0;   ///< clear width of the wall [m]
  Factors normal{}, shear{}, gradient{};
  boxbeam::PlateKind kind = boxbeam::PlateKind::wall;
};

/// The walls that a hole goes through.
std::vector<HoleCentre> centres_of(const LocalSection& section, const boxbeam::Hole& hole);

/// Stress plane sigma = a + b y + c z per N, M_y, M_z: columns of (a, b, c).
struct Plane {
  std::array<std::array<double, 3>, 3> of{};  ///< [N, M_y, M_z][a, b, c]
};
Plane plane_of(const LocalSection& section, bool with_holes, bool with_shear_lag);

}  // namespace oracle
