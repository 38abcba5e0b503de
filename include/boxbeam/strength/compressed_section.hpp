#pragma once

#include <string>
#include <vector>

#include "boxbeam/section/section.hpp"

namespace boxbeam {

class Derivation;
class Traced;

/// A plate of a section under even compression.
struct CompressedPlate {
  std::string name;       ///< "flange", "web", "round wall", "wall 2", ...
  bool round = false;     ///< the wall of a round tube
  double ratio = 0.0;     ///< c/t, or d/t of a round tube
  double limit = 0.0;     ///< of class 3
  Length thickness;       ///< of plates in class 4
  double lambda_p = 0.0;  ///< relative slenderness; of plates in class 4
  double rho = 1.0;       ///< share of its width that is effective
  Area idle;              ///< of all plates of this name, what is not effective
  int alike = 2;          ///< plates of this name
  bool outstand = false;  ///< of thin-walled paths
};

/// What of a section bears even compression.
struct CompressedSection {
  std::vector<CompressedPlate> plates;  ///< none of a solid
  bool class_4 = false;
  Area area;                ///< of the whole section
  Area effective;           ///< A in classes 1 to 3, A_eff in class 4
  Length shift_y, shift_z;  ///< of the centroid where plates do not work whole; of paths alone
  /// Why it cannot be judged, with numbers and clause; "" where it can.
  std::string obstacle;
};

/// The class of a section by its own plates, all evenly compressed, and its effective area:
///
///     internal: c/t <= 42 eps,  outstand: c/t <= 14 eps,  round tube: d/t <= 90 eps^2,
///     A_eff = A - sum (1 - rho) c t,  rho with psi = 1, k_sigma = 4, of outstands 0.43
///
/// Beyond these limits A_eff is known for boxes without stiffeners of equal webs and equal flanges,
/// for rectangular tubes and for thin-walled paths (within another profile as far as their centroid
/// stays where it is). Not judged: the rest in class 4, and polygons that are hollow or not convex,
/// whose walls nobody knows.
/// Source: EN 1993-1-1:2005, table 5.2; EN 1993-1-5:2006, 4.3(3), 4.4.
CompressedSection compressed_section_of(const Section& section, Stress yield_strength);

/// The class of a section that can be judged and its effective area, step by step; returns A, or
/// A_eff in class 4.
Traced derive_effective_area(Derivation& steps, const CompressedSection& section,
                             Stress yield_strength);

}  // namespace boxbeam
