#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

struct Verification;

/// One change of a case with which it passes: found by verifying again with it.
struct Remedy {
  enum class What {
    category,
    flanges,
    webs,
    walls,
    steel,
    throat,
    stiffeners,
    diaphragms,
    diaphragm
  };

  What what = What::category;
  std::string name;  ///< "category 112", "58 mm flanges", "S460N", "6.5 mm throat of weld foot"
  /// Category [MPa]; throat, or thickness, the largest that is changed, or of the flats [m]; f_y
  /// [Pa]; how far diaphragms are apart [m].
  double value = 0.0;
  double utilisation;  ///< the largest of the whole case with it
  std::vector<std::string> set =
      {};  ///< the keys, as --set takes them; of plates and what holds them
};

/// "detail category", "flange thickness", "web thickness", "wall thickness", "steel", "weld
/// throat", "stiffeners", "diaphragm spacing", "diaphragm thickness".
const char* to_text(Remedy::What what);

/// SI unit of its value: "Pa", "m", "1" of a category.
const char* unit_of(Remedy::What what);

/// What would make a case pass that fails, one thing at a time.
struct Remedies {
  std::vector<Remedy> found;
  std::vector<std::string> in_vain;       ///< "a detail up to category 160"
  std::vector<std::string> not_searched;  ///< with the reason: "other plates (elastic links)"
};

/// Searches them for the check that governs: fatigue by the next detail category and thicker
/// plates, yield by the next steel and thicker plates, a weld by a thicker throat. The category is
/// the next of EN 1993-1-9, figure 7.1; steels are those of the catalogue, by yield strength;
/// plates are the flanges, or the webs where a web governs, of the sections at the governing
/// segment, all by one factor of at most 4 and up to whole millimetres; throats go up to half
/// millimetres.
///
/// What gives way has more of them:
///
///     effective section         flanges, webs, flats along the compressed flange or the webs
///     shear buckling, with M    plates of its kind, flats along it, diaphragms
///     reduced stresses          plates of its kind, diaphragms: flats are not judged so
///     a force on a web          webs, diaphragms; where one takes it, a thicker one
///     distortion                flanges, webs, diaphragms
///
/// Flats have usual thicknesses and the depth that does not twist; of a web they stand in its
/// middle or its thirds, against bending a fifth of its depth from the compressed edge. Diaphragms
/// stand at equal distances, of the thickness of those that are there, else of the plate, as few as
/// will do: between those beside the governing place, else all along the beam. They bring their
/// welds along, as every case does.
///
/// Each is the least of its kind and passes as a whole case; of thicknesses and diaphragms found by
/// bisection. Nothing where the case does not fail. With another category or steel, and with
/// diaphragms, the loads stay those of `runs`, whose situations change while it searches.
Remedies remedies_of(const Project& project, std::deque<SituationRun>& runs,
                     const Verification& verification);

}  // namespace boxbeam
