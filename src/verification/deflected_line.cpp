#include "boxbeam/verification/deflected_line.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/section/normal_stress.hpp"
#include "boxbeam/section/shear_area.hpp"

namespace boxbeam {
namespace {

constexpr int pieces_per_segment = 16;
constexpr std::size_t nodes = FlexibilityPiece::nodes;
/// Gauss' rule on [-1, 1].
constexpr std::array<double, nodes> gauss_node{-0.9061798459386640, -0.5384693101056831, 0.0,
                                               0.5384693101056831, 0.9061798459386640};
constexpr std::array<double, nodes> weight_of_node{0.2369268850561891, 0.4786286704993665,
                                                   0.5688888888888889, 0.4786286704993665,
                                                   0.2369268850561891};

DividedBeam::Flexibility flexibility_at(const FlexibilityPiece& piece, double s) {
  const double u = 2.0 * (s - piece.start.value()) / piece.length.value() - 1.0;
  const std::array<double, nodes> weights = lagrange_weights(gauss_node, u);
  DividedBeam::Flexibility at;
  for (std::size_t i = 0; i < nodes; ++i) {
    at.curvature += weights[i] * piece.curvature[i];
    at.shear += weights[i] * piece.shear[i];
  }
  return at;
}

DividedBeam::Part part_of(const FlexibilityPiece& piece, double from, double to) {
  DividedBeam::Part part{from, to, flexibility_at(piece, from), flexibility_at(piece, to), {}};
  for (std::size_t i = 0; i < nodes; ++i)
    part.at[i] = flexibility_at(piece, from + 0.5 * (to - from) * (1.0 + gauss_node[i]));
  return part;
}

/// Integrates the bent axis along the beam, from no deflection and no turn at its start.
class Integration {
 public:
  Integration(const DeflectionModel& model, const BeamShift& shift)
      : model_(&model), shift_(shift) {}

  /// Precondition: the diagram has pieces, from the start of the beam to its end.
  void run(const std::vector<DividedBeam::Part>& parts, const CutForceDiagram& diagram) {
    line_.stretches.reserve(parts.size());
    rotations_.reserve(parts.size());
    std::size_t piece = 0;
    for (const DividedBeam::Part& part : parts) {
      const double middle = 0.5 * (part.from + part.to);
      while (piece + 1 < diagram.pieces.size() && diagram.pieces[piece + 1].start.value() <= middle)
        ++piece;
      add(part, diagram.pieces[piece]);
    }
  }

  /// The places of a line less those of another one, w_0 + slope (s - a).
  DeflectedLine measured() {
    double a = 0.0;
    Eigen::Vector2d w_0, slope;
    if (const auto* chord = std::get_if<Chord>(&model_->against)) {
      a = chord->from.value();
      w_0 = line_.at(chord->from);
      slope = (line_.at(chord->to) - w_0) / (chord->to - chord->from).value();
    } else if (const auto* tangent = std::get_if<Tangent>(&model_->against)) {
      a = tangent->at.value();
      w_0 = line_.at(tangent->at);
      slope = rotation_at(a);
    } else {  // the start of the line has moved and turned itself
      w_0 = -shift_.start;
      slope = -shift_.slope;
    }
    DeflectedLine line = std::move(line_);
    for (DeflectedLine::Stretch& stretch : line.stretches) {
      stretch.at_from -= w_0 + slope * (stretch.from.value() - a);
      stretch.at_to -= w_0 + slope * (stretch.to.value() - a);
      stretch.slope_from -= slope;
      stretch.slope_to -= slope;
    }
    return line;
  }

 private:
  /// The shear strains along y and z at a place.
  Eigen::Vector2d sheared_at(const DividedBeam::Flexibility& of, const CutForcePiece& cut,
                             double s) const {
    const double x = s - cut.start.value();
    return of.shear.cwiseProduct(seen({cut.V_y(x), cut.V_z(x)}));
  }

  /// What of a direction counts: in the plane z alone.
  Eigen::Vector2d seen(Eigen::Vector2d of) const {
    if (!model_->in_space) of[0] = 0.0;
    return of;
  }

  void add(const DividedBeam::Part& part, const CutForcePiece& cut) {
    const auto [from, to] = std::pair(part.from, part.to);
    const double half = 0.5 * (to - from);
    // int kappa, int (to - s) kappa, int gamma
    Eigen::Vector2d turn = Eigen::Vector2d::Zero(), lag = turn, sheared = turn;
    for (std::size_t i = 0; i < nodes; ++i) {
      const double u = gauss_node[i], weight = weight_of_node[i];
      const double s = from + half * (1.0 + u), x = s - cut.start.value();
      const Eigen::Vector3d bending(cut.N(x), cut.M_y(x), cut.M_z(x));
      const Eigen::Vector2d kappa =
          seen(part.at[i].curvature * bending + Eigen::Vector2d(0.0, shift_.curvature));
      turn += half * weight * kappa;
      lag += half * weight * (to - s) * kappa;
      sheared += half * weight * sheared_at(part.at[i], cut, s);
    }
    DeflectedLine::Stretch& stretch = line_.stretches.emplace_back();
    stretch.from = si<Length>(from);
    stretch.to = si<Length>(to);
    stretch.at_from = w_;
    rotations_.push_back(theta_);
    stretch.slope_from = theta_ + sheared_at(part.at_from, cut, from);
    w_ += theta_ * (to - from) - lag + sheared;
    theta_ -= turn;
    stretch.at_to = w_;
    stretch.slope_to = theta_ + sheared_at(part.at_to, cut, to);
  }

  /// The rotation of the section at a place where a stretch begins, or at the end of the beam.
  Eigen::Vector2d rotation_at(double s) const {
    for (std::size_t i = 0; i < rotations_.size(); ++i) {
      if (line_.stretches[i].from.value() >= s) return rotations_[i];
    }
    return theta_;
  }

  const DeflectionModel* model_;
  BeamShift shift_;
  Eigen::Vector2d w_ = Eigen::Vector2d::Zero(), theta_ = Eigen::Vector2d::Zero();
  DeflectedLine line_;
  std::vector<Eigen::Vector2d> rotations_;  ///< at the beginnings of the stretches
};

/// w = c_0 + c_1 u + c_2 u^2 + c_3 u^3 over a stretch, u from 0 to 1; along y and z.
struct Cubic {
  explicit Cubic(const DeflectedLine::Stretch& stretch) {
    const double h = (stretch.to - stretch.from).value();
    const Eigen::Vector2d rise = stretch.at_to - stretch.at_from;
    const Eigen::Vector2d a = h * stretch.slope_from, b = h * stretch.slope_to;
    c = {stretch.at_from, a, 3.0 * rise - 2.0 * a - b, a + b - 2.0 * rise};
  }

  Eigen::Vector2d at(double u) const { return c[0] + u * (c[1] + u * (c[2] + u * c[3])); }

  /// Whether it stays in one plane, as in a mechanism of the plane.
  bool bends_one_way() const {
    return std::all_of(c.begin(), c.end(), [](const auto& of) { return of.x() == 0.0; }) ||
           std::all_of(c.begin(), c.end(), [](const auto& of) { return of.y() == 0.0; });
  }

  /// d(|w|^2/2)/du.
  double outwards(double u) const { return at(u).dot(c[1] + u * (2.0 * c[2] + 3.0 * u * c[3])); }

  std::array<Eigen::Vector2d, 4> c;
};

/// Calls `look` at the places within a stretch where one direction alone turns round:
/// c_1 + 2 c_2 u + 3 c_3 u^2 = 0, without cancellation.
template <class Look>
void where_one_turns(const Cubic& of, const Look& look) {
  for (const Eigen::Index axis : {0, 1}) {
    const double c_1 = of.c[1][axis], c_2 = of.c[2][axis], c_3 = of.c[3][axis];
    const double root = std::sqrt(std::max(0.0, c_2 * c_2 - 3.0 * c_1 * c_3));
    const double q = -(c_2 + std::copysign(root, c_2));
    look(q / (3.0 * c_3));
    look(c_1 / q);
  }
}

/// Calls `look` where the axis is farthest off, both directions together, between `from` and `to`.
template <class Look>
void where_both_turn(const Cubic& of, double from, double to, const Look& look) {
  if (!(of.outwards(from) > 0.0 && of.outwards(to) < 0.0)) return;
  constexpr int halvings = 48;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (from + to);
    (of.outwards(middle) > 0.0 ? from : to) = middle;
  }
  look(from);
}

}  // namespace

Eigen::Vector2d DeflectedLine::at(Length s) const {
  const auto stretch = std::find_if(stretches.begin(), stretches.end() - 1,
                                    [&](const Stretch& of) { return s <= of.to; });
  return Cubic(*stretch).at((s - stretch->from) / (stretch->to - stretch->from));
}

LargestDeflection largest_of(const DeflectedLine& line) {
  LargestDeflection largest;
  for (const DeflectedLine::Stretch& stretch : line.stretches) {
    const Cubic cubic(stretch);
    const auto look = [&](double u) {
      if (!(u >= 0.0 && u <= 1.0)) return;  // a straight stretch has no such place, which is NaN
      const Eigen::Vector2d along = cubic.at(u);
      const double size = along.norm();
      if (size <= largest.size.value()) return;
      largest = {stretch.from + u * (stretch.to - stretch.from), si<Length>(size), along};
    };
    look(0.0);
    look(1.0);
    where_one_turns(cubic, look);
    if (cubic.bends_one_way()) continue;
    constexpr int parts = 4;
    for (int i = 0; i < parts; ++i)
      where_both_turn(cubic, static_cast<double>(i) / parts, (i + 1.0) / parts, look);
  }
  return largest;
}

DeflectionModel deflection_model_of(const Project& project) {
  const DeflectionInput& input = *project.deflection;
  DeflectionModel model;
  model.against = input.against;
  model.in_space = project.in_space;
  for (const Segment& segment : project.beam.segments) {
    for (int k = 0; k < pieces_per_segment; ++k) {
      FlexibilityPiece& piece = model.pieces.emplace_back();
      // So that the last piece ends where the segment does.
      const auto border = [&](int i) {
        return i == pieces_per_segment
                   ? segment.end()
                   : segment.start + segment.length * (static_cast<double>(i) / pieces_per_segment);
      };
      piece.start = border(k);
      piece.length = border(k + 1) - piece.start;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Length s = piece.start + 0.5 * (1.0 + gauss_node[i]) * piece.length;
        const Section section = section_at(project.beam, {s});
        piece.curvature[i] = normal_stress_plane(sums_of(outline_of(section, {}))).bottomRows<2>() /
                             input.youngs_modulus.value();
        const ShearAreas areas = shear_areas_of(section);
        piece.shear[i] = Eigen::Vector2d(1.0 / areas.y.value(), 1.0 / areas.z.value()) /
                         input.shear_modulus.value();
      }
    }
  }
  return model;
}

const std::vector<DividedBeam::Part>& DividedBeam::parts_under(const CutForceDiagram& diagram) {
  std::vector<double> jumps;
  jumps.reserve(diagram.pieces.size());
  for (const CutForcePiece& cut : diagram.pieces) jumps.push_back(cut.start.value());
  if (!parts_.empty() && jumps == jumps_) return parts_;
  jumps_ = std::move(jumps);
  parts_.clear();
  for (const FlexibilityPiece& piece : model_->pieces) {
    const std::vector<double> borders = borders_in(piece);
    for (std::size_t i = 0; i + 1 < borders.size(); ++i)
      parts_.push_back(part_of(piece, borders[i], borders[i + 1]));
  }
  return parts_;
}

std::vector<double> DividedBeam::borders_in(const FlexibilityPiece& piece) const {
  const double start = piece.start.value(), end = (piece.start + piece.length).value();
  std::vector<double> borders{start, end};
  const auto add = [&](double at) {
    if (at > start && at < end) borders.push_back(at);
  };
  for (const double at : jumps_) add(at);
  if (const auto* chord = std::get_if<Chord>(&model_->against)) {
    add(chord->from.value());
    add(chord->to.value());
  } else if (const auto* tangent = std::get_if<Tangent>(&model_->against)) {
    add(tangent->at.value());
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
  return borders;
}

DeflectedLine DividedBeam::line_under(const CutForceDiagram& diagram, const BeamShift& shift) {
  Integration integration(*model_, shift);
  integration.run(parts_under(diagram), diagram);
  return integration.measured();
}

}  // namespace boxbeam
