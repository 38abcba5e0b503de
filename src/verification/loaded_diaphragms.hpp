#pragma once

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "boxbeam/verification/gates.hpp"
#include "boxbeam/verification/patch_checks.hpp"
#include "most_by_name.hpp"
#include "patch_search.hpp"

namespace boxbeam {

/// What forces that diaphragms take do to their plates, edges and welds beside what checks judge.
class LoadedDiaphragms {
 public:
  explicit LoadedDiaphragms(const Project& project) : project_(&project) {}

  /// A patch that its diaphragm leads to the webs, and how that bears it.
  void take(const Patch& patch, const Borne& way, double load_factor);

  /// Plates in shear, by their use.
  const UseByName& sheared() const { return sheared_; }
  /// Of boxes in space, of each force the largest.
  std::vector<IntoDiaphragm> into() const;
  /// What presses an edge by more than its strength.
  void add_edges_to(std::vector<NotJudged>& found) const;
  /// Strips beside access holes that bridge them by more than their strength.
  void add_bridges_to(std::vector<NotJudged>& found) const;

 private:
  void take_into(const Patch& patch, const Borne& way, IntoDiaphragm::Part part, double use,
                 double load_factor);
  void take_welds(const Patch& patch, const Borne& way, const StiffenerWeld& weld,
                  double load_factor);
  /// The plate that leads to the webs what turns off from flanges.
  void take_plate_between(const Patch& patch, const Borne& way, double load_factor);
  /// The plate that leads to the webs what stands between them, or beside.
  void take_plate_under(const Patch& patch, const Borne& way, const BearingStiffener& stiffener,
                        double load_factor);

  const Project* project_;
  UseByName sheared_, edges_, bridged_;
  std::map<std::tuple<const Diaphragm*, IntoDiaphragm::Part, std::string>, IntoDiaphragm> into_;
};

}  // namespace boxbeam
