#include "load_numbers.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "modal_motion.hpp"

namespace boxbeam {
namespace {

constexpr Eigen::Index numbers_of_piece = 8, numbers_of_point = 6;

/// Pieces without load that end where those of either end.
std::vector<LineLoad> pieces_of_both(const std::vector<LineLoad>& lines,
                                     const std::vector<LineLoad>& others) {
  std::vector<LineLoad> finer;
  std::vector<Length> ends;
  for (const std::vector<LineLoad>* of : {&lines, &others})
    for (const LineLoad& line : *of) ends.push_back(line.start + line.length);
  std::sort(ends.begin(), ends.end());
  constexpr double round_off = 1e-12;
  const Length close = round_off * ends.back();
  Length from;
  for (const Length& end : ends) {
    if (end - from <= close) continue;
    LineLoad& piece = finer.emplace_back();
    piece.start = from;
    piece.length = end - from;
    from = end;
  }
  return finer;
}

/// The load of the same name and place, a millionth of the beam apart at most, for one without name
/// any there; else a new one there.
PointLoad& same_point(const PointLoad& load, Length beam, std::vector<PointLoad>& points) {
  const Length close = 1e-6 * beam;
  const auto same = std::find_if(points.begin(), points.end(), [&](const PointLoad& of) {
    const Length apart = of.s > load.s ? of.s - load.s : load.s - of.s;
    return (load.name.empty() || of.name == load.name) && apart <= close;
  });
  if (same != points.end()) return *same;
  PointLoad& added = points.emplace_back();
  added.s = load.s;
  added.at = load.at;
  added.name = load.name;
  return added;
}

/// Adds a load to one that may stand a little apart.
void add_carried(const PointLoad& load, PointLoad& sum) {
  const Eigen::Vector3d arm((load.s - sum.s).value(), 0.0, 0.0);
  sum.force += load.force;
  sum.moment += load.moment + arm.cross(load.force);
}

Length length_of(const std::vector<LineLoad>& lines) {
  return lines.back().start + lines.back().length;
}

}  // namespace

Eigen::RowVectorXd LoadNumbers::of(const BeamLoads& loads) {
  if (places_.lines.empty()) {
    for (const LineLoad& line : loads.lines) {
      LineLoad& piece = places_.lines.emplace_back();
      piece.start = line.start;
      piece.length = line.length;
    }
  }
  std::vector<PointLoad> points = places_.points;
  for (PointLoad load : loads.points) {
    if (slides(load)) {
      // From where it is to the start of the beam, which stays.
      load.moment += Eigen::Vector3d(load.s.value(), 0.0, 0.0).cross(load.force);
      load.s = Length();
    }
    add_carried(load, same_point(load, length_of(places_.lines), points));
  }
  const auto pieces = static_cast<Eigen::Index>(loads.lines.size()),
             count = static_cast<Eigen::Index>(points.size());
  Eigen::RowVectorXd numbers(numbers_of_piece * pieces + numbers_of_point * count);
  Eigen::Index at = 0;
  for (const LineLoad& line : loads.lines) {
    const auto& [x, y, z] = line.force;
    const auto& [about_x, about_y, about_z] = line.couple;
    for (const double number :
         {x.c[0], y.c[0], y.c[1], z.c[0], z.c[1], about_x.c[0], about_y.c[0], about_z.c[0]})
      numbers[at++] = number;
  }
  for (PointLoad& load : points) {
    numbers.segment<3>(at) = load.force.transpose();
    numbers.segment<3>(at + 3) = load.moment.transpose();
    at += numbers_of_point;
    load.force.setZero();
    load.moment.setZero();
  }
  places_.points = std::move(points);
  return numbers;
}

bool LoadNumbers::slides(const PointLoad& load) const {
  return std::find(sliding_.begin(), sliding_.end(), load.name) != sliding_.end();
}

BeamLoads LoadNumbers::loads_of(const Eigen::VectorXd& numbers, const BeamLoads& rigid) const {
  BeamLoads loads = places_;
  Eigen::Index at = 0;
  for (LineLoad& line : loads.lines) {
    line.force[0] = {{numbers[at]}};
    line.force[1] = {{numbers[at + 1], numbers[at + 2]}};
    line.force[2] = {{numbers[at + 3], numbers[at + 4]}};
    for (std::size_t axis = 0; axis < 3; ++axis)
      line.couple[axis] = {{numbers[at + 5 + static_cast<Eigen::Index>(axis)]}};
    at += numbers_of_piece;
  }
  for (PointLoad& load : loads.points) {
    load.force = numbers.segment<3>(at);
    load.moment = numbers.segment<3>(at + 3);
    at += numbers_of_point;
    if (!slides(load)) continue;
    const auto here = std::find_if(rigid.points.begin(), rigid.points.end(),
                                   [&](const PointLoad& of) { return of.name == load.name; });
    if (here == rigid.points.end()) continue;
    load.s = here->s;
    load.at = here->at;
    load.moment -= Eigen::Vector3d(load.s.value(), 0.0, 0.0).cross(load.force);
  }
  return loads;
}

Eigen::VectorXd LoadNumbers::arms() const {
  const double length = length_of(places_.lines).value();
  const auto pieces = static_cast<Eigen::Index>(places_.lines.size()),
             points = static_cast<Eigen::Index>(places_.points.size());
  Eigen::VectorXd arms(numbers_of_piece * pieces + numbers_of_point * points);
  Eigen::Index at = 0;
  for (const LineLoad& line : places_.lines) {
    const double h = line.length.value(), force = h * length;
    for (const double arm : {force, force, force * h, force, force * h, h, h, h}) arms[at++] = arm;
  }
  for (Eigen::Index i = 0; i < points; ++i) {
    arms.segment<3>(at).setConstant(length);
    arms.segment<3>(at + 3).setOnes();
    at += numbers_of_point;
  }
  return arms;
}

void add_bending(const BeamLoads& bending, BeamLoads& loads) {
  const Length beam = length_of(bending.lines);
  for (const PointLoad& load : bending.points) {
    if (load.force.isZero(0.0) && load.moment.isZero(0.0)) continue;
    add_carried(load, same_point(load, beam, loads.points));
  }
  const std::vector<LineLoad> pieces = pieces_of_both(loads.lines, bending.lines);
  loads.lines = on_stretches_of(loads.lines, pieces);
  add(loads.lines, 1.0, on_stretches_of(bending.lines, pieces));
}

}  // namespace boxbeam
