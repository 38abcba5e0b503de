#pragma once

#include <deque>
#include <string>
#include <vector>

#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

struct Verification;

/// One change of a case with which it passes: found by verifying again with it.
struct Remedy {
  enum class What { category, flanges, webs, walls, steel, throat, diaphragms };

  What what = What::category;
  std::string name;  ///< "category 112", "58 mm flanges", "S460N", "6.5 mm throat of weld foot"
  /// Category [MPa]; throat, or thickness, the largest that is changed [m]; f_y [Pa]; how far
  /// diaphragms are apart [m].
  double value = 0.0;
  double utilisation;                 ///< the largest of the whole case with it
  std::vector<std::string> set = {};  ///< the keys, as --set takes them; of plates only
};

/// "detail category", "flange thickness", "web thickness", "wall thickness", "steel", "weld
/// throat", "diaphragm spacing".
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
/// millimetres. Plates that buckle, and webs that forces come into, likewise by thicker plates, and
/// by diaphragms at equal distances, of the thickness of those that are there, else of the plate,
/// as few as will do; a box that is distorted by such diaphragms and by thicker plates. Each is the
/// least found by bisection, and passes as a whole case. Nothing where the case does not fail. With
/// another category or steel the loads stay those of `runs`, whose situations change while it
/// searches.
Remedies remedies_of(const Project& project, std::deque<SituationRun>& runs,
                     const Verification& verification);

}  // namespace boxbeam
