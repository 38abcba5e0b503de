#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"

namespace boxbeam {

/// How a unit deflection at one place follows from the cut forces along the beam: the deflection is
/// the sum of weight_N N + weight_M M + weight_V V over the nodes.
///
///     w(s_j) = int m_j kappa ds + int v_j V/(G A_v) ds,  kappa = M/(E I_y)
///
/// kappa is the slope of the normal stress along z over E: in unsymmetric sections, or where the
/// centroid lies off the axis, it depends on N too (normal_stress_plane).
///
/// m_j and v_j are the cut forces under a force of one at s_j, the beam supported at the two ends
/// of the line from which the deflection is measured. Exact but for the quadrature (Gauss, five
/// nodes to each sixteenth of a segment). A_v: EN 1993-1-1 6.2.6 (webs of boxes, 2 A/pi of round
/// tubes, 5/6 of solid plates). Source: virtual work; Timoshenko, Strength of Materials I,
/// article 68.
struct DeflectionInfluence {
  Length at;
  std::vector<double> weight_N, weight_M, weight_V;
};

/// The nodes and the influences at so many places evenly along the beam.
struct DeflectionModel {
  std::vector<Length> nodes;
  std::vector<DeflectionInfluence> influences;
};

DeflectionModel deflection_model_of(const Project& project);

/// Deflections at the places of the model [m], positive along +z.
std::vector<double> deflections_of(const DeflectionModel& model, const CutForceDiagram& diagram);

/// The largest deflection in any situation against its limit. Small displacements, elastic,
/// quasi-static: the loads are those of the rigid mechanism. Nothing for a
/// beam that never bends.
std::optional<Check> check_deflection(const Project& project, const std::deque<SituationRun>& runs);

}  // namespace boxbeam
