#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/reference_beam.hpp"
#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {
namespace {

using flexible::Element;
using flexible::Structure;

/// Digits that a strength check needs at least.
constexpr double needed_digits = 3.0;
constexpr double all_digits = -std::numeric_limits<double>::digits10 - 1.0;

/// Where the cantilever is cut: its stiffnesses are no round numbers.
constexpr double cut = 0.382;

/// The unit cantilever cut in two, held at its root and welded at the cut by joints of one
/// stiffness.
struct WeldedBeam {
  flexible::Mechanism mechanism;
  double exact = 0.0;  ///< deflection of its end
};

/// Deflection L^3/(3 EI) of the beam, 1/c + L^2/c of the root's shift and turn, 1/c + (L - a)^2/c
/// of those of the weld at a.
WeldedBeam welded_beam(double ratio, int parts) {
  const double c = 3.0 * ratio;  // 3 EI/L^3 is the beam's own stiffness
  WeldedBeam beam{unit_cantilever(parts, Element::corrected), 0.0};
  beam.mechanism.joints.front().stiffness = {c, c, c};
  flexible::Link& first = beam.mechanism.links.front();
  first.length = first.stretches.front().length = cut;
  first.kind = flexible::LinkKind::full;
  flexible::Link second = first;
  second.name = "second half";
  second.origin = {cut, 0.0};
  second.length = second.stretches.front().length = 1.0 - cut;
  beam.mechanism.links.push_back(second);
  beam.mechanism.joints.push_back({"weld", {0, {cut, 0.0}}, {1, {0.0, 0.0}}, 0.0, {c, c, c}, {}});
  beam.mechanism.loads.front().at = {1, {1.0 - cut, 0.0}};
  const long double behind = 1.0L - static_cast<long double>(cut);
  beam.exact = static_cast<double>(1.0L / 3.0L + (3.0L + behind * behind) / c);
  return beam;
}

double deflection_by_boxbeam(const WeldedBeam& beam) {
  const Structure structure = structure_of(beam.mechanism);
  return motion_at(structure, beam.mechanism.loads.front().at, flexible::static_response(structure))
      .y();
}

/// Strain between two places that move as rigid elements: rows of both, the first one's negative.
void add_spring(const Eigen::MatrixXd& strain, const Eigen::Matrix3d& stiffness,
                Eigen::MatrixXd& K) {
  K += strain.transpose() * stiffness * strain;
}

/// The same springs and joints as one stiffness matrix in the motions of all elements.
double deflection_by_stiffness(const WeldedBeam& beam) {
  const Structure structure = structure_of(beam.mechanism);
  const auto size = 3 * static_cast<Eigen::Index>(structure.elements());
  std::vector<Eigen::Index> first{0};
  for (const flexible::DividedLink& link : structure.links) {
    first.push_back(first.back() + 3 * static_cast<Eigen::Index>(link.elements.size()));
  }
  const auto at = [&](std::size_t link, std::size_t element) {
    return first[link] + 3 * static_cast<Eigen::Index>(element);
  };
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t l = 0; l < structure.links.size(); ++l) {
    const flexible::DividedLink& link = structure.links[l];
    for (std::size_t i = 0; i < link.springs.size(); ++i) {
      const flexible::SpringElement& spring = link.springs[i];
      Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
      stiffness(0, 0) = 1.0 / spring.axial;
      stiffness.bottomRightCorner<2, 2>() = spring.bending.inverse();
      Eigen::MatrixXd strain = Eigen::MatrixXd::Zero(3, size);
      for (const std::size_t element : {i, i + 1}) {
        const double sign = element == i ? -1.0 : 1.0;
        Eigen::Matrix3d to_spring = Eigen::Matrix3d::Identity();
        to_spring(1, 2) = spring.place - link.elements[element].node;
        strain.middleCols<3>(at(l, element)) = sign * to_spring;
      }
      add_spring(strain, stiffness, K);
    }
  }
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    const Structure::Ends& ends = structure.joints[j];
    Eigen::MatrixXd gap = Eigen::MatrixXd::Zero(3, size);
    for (const auto& [grip, sign] : {std::pair(&ends.a, -1.0), std::pair(&ends.b, 1.0)}) {
      if (grip->link == flexible::ground) continue;
      gap.middleCols<3>(at(static_cast<std::size_t>(grip->link), grip->element)) +=
          sign * ends.axes * grip->motion;
    }
    const std::array<double, 3>& c = beam.mechanism.joints[j].stiffness;
    add_spring(gap, Eigen::Vector3d(c[0], c[1], c[2]).asDiagonal(), K);
  }
  const flexible::Grip& grip = structure.loads.front();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(size);
  const Eigen::Index end = at(static_cast<std::size_t>(grip.link), grip.element);
  load.segment<3>(end) = grip.motion.transpose() * beam.mechanism.loads.front().constant;
  const Eigen::LDLT<Eigen::MatrixXd> factors(K);
  const Eigen::VectorXd q = factors.solve(load);
  return (grip.motion * q.segment<3>(end)).y();
}

Cell cell_of(double ratio, int parts, double value, double exact) {
  Cell cell{ratio, static_cast<double>(parts), Outcome::solved, {}, ""};
  const double error = std::abs(value / exact - 1.0);
  const double digits =
      std::isfinite(error)
          ? std::clamp(-std::log10(std::max(error, std::pow(10.0, all_digits))), 0.0, -all_digits)
          : 0.0;
  cell.value = digits;
  if (digits < needed_digits) cell.outcome = Outcome::wrong;
  return cell;
}

}  // namespace

Map stiff_joint_map(const Scenes&, const Effort& effort) {
  Map map;
  map.name = "stability-stiff-joints";
  map.title = "Digits left where joints are stiff";
  map.scene = fmt::format("cantilever welded at {} of its length, deflection of its end", cut);
  map.reference = "L^3/(3 EI) + 2/c + (L^2 + (L - a)^2)/c, long double";
  map.x = {"stiffness of the joints over that of the beam", true};
  map.y = {"parts of each piece", true};
  map.value = "digits left";
  map.panels = {{"boxbeam: flexibilities, gathered link by link", {}, false},
                {"stiffness matrix in absolute coordinates, LDLT", {}, true}};
  const int step = effort.quick ? 2 : 1;
  for (int parts = 1; parts <= 32; parts *= effort.quick ? 4 : 2) {
    for (int power = 0; power <= 20; power += step) {
      const double ratio = std::pow(10.0, power);
      const WeldedBeam beam = welded_beam(ratio, parts);
      try {
        map.panels[0].cells.push_back(
            cell_of(ratio, parts, deflection_by_boxbeam(beam), beam.exact));
      } catch (const AnalysisError& error) {
        map.panels[0].cells.push_back(
            {ratio, static_cast<double>(parts), Outcome::refused, {}, error.failure().what});
      }
      map.panels[1].cells.push_back(
          cell_of(ratio, parts, deflection_by_stiffness(beam), beam.exact));
    }
  }
  const auto fewest = [](const MapPanel& panel) {
    return *std::min_element(panel.cells.begin(), panel.cells.end(),
                             [](const Cell& a, const Cell& b) { return *a.value < *b.value; })
                ->value;
  };
  map.lesson = fmt::format(
      "boxbeam keeps {:.0f} digits or more however stiff the joints; a stiffness matrix in "
      "absolute "
      "coordinates loses one with every power of ten and is silently wrong in {} of {} trials.",
      std::floor(fewest(map.panels[0])), map.panels[1].count(Outcome::wrong),
      map.panels[1].cells.size());
  return map;
}

}  // namespace boxbeam::study
