#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "boxbeam/project/project.hpp"
#include "rules.hpp"
#include "section_stress.hpp"

namespace oracle {

/// The cut forces over the instants of a situation, each in a column.
using Cuts = Eigen::Array<double, Eigen::Dynamic, boxbeam::cut_force::count>;

/// The first wall of a section that may buckle under these cut forces, "" where none may: EN
/// 1993-1-1, table 5.2: even compression 42 eps, round tubes 90 eps^2, webs by their stress; EN
/// 1993-1-5, 5.1(2): shear buckling above 72 eps/eta, eta = 1.2. `load_factors`: of the cut forces.
std::string slender_wall_at(const boxbeam::Project& project, const Rules& rules,
                            const LocalSection& section, const boxbeam::Station& station,
                            std::size_t segment, const std::vector<Cuts>& cuts,
                            const std::vector<double>& load_factors);

}  // namespace oracle
