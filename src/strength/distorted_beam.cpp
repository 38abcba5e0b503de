// Distortion along a beam: a beam on an elastic foundation, by elements.
#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "boxbeam/strength/box_distortion.hpp"
#include "gauss_rule.hpp"

namespace boxbeam {
namespace {

/// Shapes of an element of a beam that bends and shears, of angle and turn at both ends, at a part
/// of its length; phi = 12 E I/(S L^2). Exact where no foundation resists.
/// Source: Friedman, Kosmatka, Computers and Structures 47 (1993), recalled.
struct Shapes {
  Eigen::Vector4d angle, turn, turn_change;

  Shapes(double x, double L, double phi)
      : angle((1.0 - x) * (1.0 + x - 2.0 * x * x + phi), L * x * (1.0 - x) * (1.0 - x + 0.5 * phi),
              x * (3.0 * x - 2.0 * x * x + phi), -L * x * (1.0 - x) * (x + 0.5 * phi)),
        turn(6.0 * x * (x - 1.0) / L, (1.0 - x) * (1.0 - 3.0 * x + phi), 6.0 * x * (1.0 - x) / L,
             x * (3.0 * x - 2.0 + phi)),
        turn_change((12.0 * x - 6.0) / (L * L), (6.0 * x - 4.0 - phi) / L,
                    (6.0 - 12.0 * x) / (L * L), (6.0 * x - 2.0 + phi) / L) {
    for (Eigen::Vector4d* of : {&angle, &turn, &turn_change}) *of /= 1.0 + phi;
  }
};

/// gamma' - theta, the same all along the element.
Eigen::Vector4d turning_apart(double L, double phi) {
  return phi / (1.0 + phi) * Eigen::Vector4d(-1.0 / L, -0.5, 1.0 / L, -0.5);
}

double mean_of(const DistortedBeam::AtGauss& values) {
  double mean = 0.0;
  for (std::size_t g = 0; g < values.size(); ++g) mean += gauss_weight[g] * values[g];
  return mean;
}

double phi_of(const DistortedBeam& beam, std::size_t element) {
  const double L = beam.nodes[element + 1] - beam.nodes[element];
  return 12.0 * mean_of(beam.warping_stiffness[element]) /
         (mean_of(beam.shear_stiffness[element]) * L * L);
}

}  // namespace

DistortedBeam::AtGauss DistortedBeam::places(std::size_t element) const {
  AtGauss at;
  for (std::size_t g = 0; g < gauss_points; ++g)
    at[g] = std::lerp(nodes[element], nodes[element + 1], gauss_place[g]);
  return at;
}

std::size_t DistortedBeam::nearest(double s) const {
  const auto above = std::lower_bound(nodes.begin(), nodes.end(), s);
  if (above == nodes.begin()) return 0;
  const auto index = static_cast<std::size_t>(above - nodes.begin());
  if (above == nodes.end() || s - nodes[index - 1] < nodes[index] - s) return index - 1;
  return index;
}

DistortedBeam distorted_beam(const std::vector<double>& places,
                             const std::function<BoxCell(double)>& cell_at, double E, double nu,
                             double part) {
  assert(places.size() > 1);
  constexpr double inside = 1e-6;  // on this side of a jump
  DistortedBeam beam;
  beam.nodes = {places.front()};
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double from = places[i], length = places[i + 1] - from;
    double lambda = 0.0;
    for (const double x : {inside, 0.5, 1.0 - inside})
      lambda = std::max(lambda, cell_distortion_of(cell_at(from + x * length), E, nu).decay);
    const int count = std::max(1, static_cast<int>(std::ceil(length * lambda / part)));
    for (int k = 1; k <= count; ++k)
      beam.nodes.push_back(k < count ? from + length * k / count : places[i + 1]);
  }
  const std::size_t elements = beam.nodes.size() - 1;
  for (auto* of : {&beam.warping_stiffness, &beam.shear_stiffness, &beam.frame_stiffness,
                   &beam.taper, &beam.of_torque})
    of->resize(elements);
  beam.diaphragms.assign(elements + 1, 0.0);
  for (std::size_t e = 0; e < elements; ++e) {
    const DistortedBeam::AtGauss at = beam.places(e);
    const BoxCell from = cell_at(at.front()), to = cell_at(at.back());
    const double b_slope = (to.width - from.width).value() / (at.back() - at.front());
    const double h_slope = (to.height - from.height).value() / (at.back() - at.front());
    for (std::size_t g = 0; g < DistortedBeam::gauss_points; ++g) {
      const BoxCell cell = cell_at(at[g]);
      const CellDistortion of = cell_distortion_of(cell, E, nu);
      beam.warping_stiffness[e][g] = 0.25 * E * of.warping_inertia;
      beam.shear_stiffness[e][g] = of.shear_stiffness;
      beam.frame_stiffness[e][g] = of.frame_stiffness;
      const double wider = b_slope / cell.width.value(), deeper = h_slope / cell.height.value();
      beam.taper[e][g] = wider + deeper;
      beam.of_torque[e][g] = 0.5 * (deeper - wider);
    }
  }
  return beam;
}

DistortionSolver::DistortionSolver(DistortedBeam beam) : beam_(std::move(beam)) {
  const std::size_t count = beam_.nodes.size();
  std::vector<Eigen::Matrix2d> diagonal(count, Eigen::Matrix2d::Zero());
  beside_.assign(count, Eigen::Matrix2d::Zero());
  for (std::size_t e = 0; e + 1 < count; ++e) {
    const double L = beam_.nodes[e + 1] - beam_.nodes[e], phi = phi_of(beam_, e);
    const Eigen::Vector4d sheared = turning_apart(L, phi);
    Eigen::Matrix4d& K = elements_.emplace_back(Eigen::Matrix4d::Zero());
    for (std::size_t g = 0; g < DistortedBeam::gauss_points; ++g) {
      const Shapes shapes(gauss_place[g], L, phi);
      const Eigen::Vector4d bent = shapes.turn_change + beam_.taper[e][g] * shapes.turn;
      K += gauss_weight[g] * L *
           (beam_.warping_stiffness[e][g] * bent * bent.transpose() +
            beam_.shear_stiffness[e][g] * sheared * sheared.transpose() +
            beam_.frame_stiffness[e][g] * shapes.angle * shapes.angle.transpose());
    }
    diagonal[e] += K.topLeftCorner<2, 2>();
    diagonal[e + 1] += K.bottomRightCorner<2, 2>();
    beside_[e] = K.topRightCorner<2, 2>();
  }
  const auto hold = [&](std::size_t node, Eigen::Index freedom) {
    diagonal[node].row(freedom).setZero();
    diagonal[node].col(freedom).setZero();
    diagonal[node](freedom, freedom) = 1.0;
    beside_[node].row(freedom).setZero();
    if (node > 0) beside_[node - 1].col(freedom).setZero();
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (is_rigid(i))
      hold(i, 0);
    else
      diagonal[i](0, 0) += beam_.diaphragms[i];
  }
  if (beam_.start_held) hold(0, 1);
  if (beam_.end_held) hold(count - 1, 1);
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) diagonal[i] -= beside_[i - 1].transpose() * pivots_[i - 1] * beside_[i - 1];
    pivots_.push_back(diagonal[i].inverse());
  }
}

bool DistortionSolver::is_rigid(std::size_t node) const {
  return std::isinf(beam_.diaphragms[node]) || (node == 0 && beam_.start_held) ||
         (node + 1 == beam_.nodes.size() && beam_.end_held);
}

Eigen::Vector4d DistortionSolver::line_load(std::size_t element,
                                            const DistortedBeam::AtGauss& line) const {
  const double L = beam_.nodes[element + 1] - beam_.nodes[element], phi = phi_of(beam_, element);
  Eigen::Vector4d load = Eigen::Vector4d::Zero();
  for (std::size_t g = 0; g < DistortedBeam::gauss_points; ++g)
    load += gauss_weight[g] * L * line[g] * Shapes(gauss_place[g], L, phi).angle;
  return load;
}

Distortion DistortionSolver::solve(const std::vector<double>& loads,
                                   const std::vector<DistortedBeam::AtGauss>& lines) const {
  const std::size_t count = beam_.nodes.size();
  assert(loads.size() == count && (lines.empty() || lines.size() + 1 == count));
  std::vector<Eigen::Vector4d> on_elements(count - 1, Eigen::Vector4d::Zero());
  std::vector<Eigen::Vector2d> rest(count, Eigen::Vector2d::Zero());
  for (std::size_t i = 0; i < count; ++i) rest[i][0] = loads[i];
  for (std::size_t e = 0; e < lines.size(); ++e) {
    on_elements[e] = line_load(e, lines[e]);
    rest[e] += on_elements[e].head<2>();
    rest[e + 1] += on_elements[e].tail<2>();
  }
  for (std::size_t i = 0; i < count; ++i)
    if (is_rigid(i)) rest[i][0] = 0.0;
  if (beam_.start_held) rest.front()[1] = 0.0;
  if (beam_.end_held) rest.back()[1] = 0.0;
  for (std::size_t i = 1; i < count; ++i)
    rest[i] -= beside_[i - 1].transpose() * pivots_[i - 1] * rest[i - 1];
  std::vector<Eigen::Vector2d> found(count);
  for (std::size_t i = count; i-- > 0;) {
    if (i + 1 < count) rest[i] -= beside_[i] * found[i + 1];
    found[i] = pivots_[i] * rest[i];
  }

  Distortion distortion;
  distortion.angle.resize(count);
  distortion.moment.resize(count);
  distortion.held.resize(count);
  std::vector<double> borne(count, 0.0);  // by the elements
  for (std::size_t i = 0; i < count; ++i) distortion.angle[i] = found[i][0];
  for (std::size_t e = 0; e + 1 < count; ++e) {
    Eigen::Vector4d at;
    at << found[e], found[e + 1];
    // By balance, which is far better than the second derivative of the cubics.
    const Eigen::Vector4d ends = elements_[e] * at - on_elements[e];
    distortion.moment[e] = ends[1];
    distortion.moment[e + 1] = -ends[3];
    distortion.shear.push_back({-ends[0], ends[2]});
    borne[e] += ends[0];
    borne[e + 1] += ends[2];
  }
  for (std::size_t i = 0; i < count; ++i) {
    distortion.held[i] =
        is_rigid(i) ? loads[i] - borne[i] : beam_.diaphragms[i] * distortion.angle[i];
  }
  return distortion;
}

}  // namespace boxbeam
