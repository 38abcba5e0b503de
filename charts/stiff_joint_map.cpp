#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "boxbeam/core/error.hpp"
#include "charts/digits_left.hpp"
#include "charts/reference_beam.hpp"
#include "charts/topics.hpp"

namespace boxbeam::charts {
namespace {

using flexible::Element;
using flexible::Structure;

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

/// Where a rigid element's coordinates begin among those of all.
class Places {
 public:
  explicit Places(const Structure& structure) {
    for (const flexible::DividedLink& link : structure.links) {
      first_.push_back(size_);
      size_ += 3 * static_cast<Eigen::Index>(link.elements.size());
    }
  }
  Eigen::Index size() const { return size_; }
  Eigen::Index of(std::size_t link, std::size_t element) const {
    return first_[link] + 3 * static_cast<Eigen::Index>(element);
  }
  Eigen::Index of(const flexible::Grip& grip) const {
    return of(static_cast<std::size_t>(grip.link), grip.element);
  }

 private:
  std::vector<Eigen::Index> first_;
  Eigen::Index size_ = 0;
};

/// Adds springs between neighbouring elements: strain^T c strain.
void add_springs(const Structure& structure, const Places& places, Eigen::MatrixXd& K) {
  for (std::size_t l = 0; l < structure.links.size(); ++l) {
    const flexible::DividedLink& link = structure.links[l];
    for (std::size_t i = 0; i < link.springs.size(); ++i) {
      const flexible::SpringElement& spring = link.springs[i];
      Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
      c(0, 0) = 1.0 / spring.axial;
      c.bottomRightCorner<2, 2>() = spring.bending.inverse();
      Eigen::Matrix<double, 3, 6> strain;
      strain << -Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Identity();
      strain(1, 2) = -(spring.place - link.elements[i].node);
      strain(1, 5) = spring.place - link.elements[i + 1].node;
      const Eigen::Index at = places.of(l, i);
      K.block<6, 6>(at, at) += strain.transpose() * c * strain;
    }
  }
}

/// Adds the joints: gap^T c gap.
void add_joints(const Structure& structure, const Places& places, Eigen::MatrixXd& K) {
  for (std::size_t j = 0; j < structure.joints.size(); ++j) {
    const Structure::Ends& ends = structure.joints[j];
    Eigen::MatrixXd gap = Eigen::MatrixXd::Zero(3, K.cols());
    for (const auto& [grip, sign] : {std::pair(&ends.a, -1.0), std::pair(&ends.b, 1.0)}) {
      if (grip->link == flexible::ground) continue;
      gap.middleCols<3>(places.of(*grip)) = sign * ends.axes * grip->motion;
    }
    const Eigen::Vector3d c(structure.mechanism->joints[j].stiffness.data());
    K += gap.transpose() * c.asDiagonal() * gap;
  }
}

/// The same springs and joints as one stiffness matrix in the motions of all elements.
double deflection_by_stiffness(const WeldedBeam& beam) {
  const Structure structure = structure_of(beam.mechanism);
  const Places places(structure);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(places.size(), places.size());
  add_springs(structure, places, K);
  add_joints(structure, places, K);
  const flexible::Grip& grip = structure.loads.front();
  const Eigen::Index end = places.of(grip);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(places.size());
  load.segment<3>(end) = grip.motion.transpose() * beam.mechanism.loads.front().constant;
  const Eigen::LDLT<Eigen::MatrixXd> factors(K);
  const Eigen::VectorXd q = factors.solve(load);
  return (grip.motion * q.segment<3>(end)).y();
}

Cell cell_of(double ratio, int parts, double value, double exact) {
  return digits_cell(ratio, static_cast<double>(parts), relative_error(value, exact));
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
  double fewest = most_digits;
  for (const Cell& cell : map.panels[0].cells) fewest = std::min(fewest, cell.value.value_or(0.0));
  map.lesson = fmt::format(
      "boxbeam keeps {:.0f} digits or more however stiff the joints; a stiffness matrix in "
      "absolute "
      "coordinates loses one with every power of ten and is silently wrong in {} of {} trials.",
      std::floor(fewest), map.panels[1].count(Outcome::wrong), map.panels[1].cells.size());
  return map;
}

}  // namespace boxbeam::charts
