#include "kinked_flanges.hpp"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <numbers>

#include "bent_flanges.hpp"
#include "boxbeam/section/section_properties.hpp"
#include "flat_plates.hpp"
#include "patch_search.hpp"
#include "plate_steps.hpp"

namespace boxbeam {
namespace {

using Eigen::Vector2d;

/// Of what lies in the same direction beside a plate the nearest; its distance.
std::pair<const FlatPlate*, double> going_on(const FlatPlate& of,
                                             const std::vector<FlatPlate>& others) {
  const Vector2d along = of.direction(), across = of.normal();
  const auto reach = [&](const FlatPlate& plate) -> std::pair<double, double> {
    const double a = along.dot(plate.ends[0]), b = along.dot(plate.ends[1]);
    return {std::min(a, b), std::max(a, b)};
  };
  std::pair<const FlatPlate*, double> nearest{nullptr, std::numeric_limits<double>::infinity()};
  const auto [low, high] = reach(of);
  for (const FlatPlate& other : others) {
    if (std::abs(across.dot(other.direction())) > hardly_turned) continue;
    const auto [from, to] = reach(other);
    if (std::min(high, to) - std::max(low, from) < 0.5 * std::min(high - low, to - from)) continue;
    const double by = std::abs(across.dot(other.middle() - of.middle()));
    if (by < nearest.second) nearest = {&other, by};
  }
  return nearest;
}

/// As one plate does, but for unlike thicknesses, whose faces may be flush, and a misalignment of a
/// tenth (EN ISO 5817, 507, level B): with more its force turns off twice.
bool goes_on(const FlatPlate& of, const std::pair<const FlatPlate*, double>& in) {
  if (in.first == nullptr) return false;
  const double other = in.first->thickness;
  return in.second <= 0.5 * std::abs(of.thickness - other) + 0.1001 * std::min(of.thickness, other);
}

/// Whether an end of a plate lies on one of others: what it bears goes on by these.
bool stands_on_one(const FlatPlate& of, const std::vector<FlatPlate>& others) {
  for (const Vector2d& end : of.ends) {
    for (const FlatPlate& other : others) {
      const Vector2d from = end - other.ends[0], along = other.direction();
      const double length = (other.ends[1] - other.ends[0]).norm(), near = other.thickness;
      const double at = along.dot(from);
      if (at >= -near && at <= length + near && std::abs(other.normal().dot(from)) <= near)
        return true;
    }
  }
  return false;
}

/// The turn of a plate's slope square to it, behind less before: the larger one of its two ends.
double turn_of(const FlatPlate& before, const FlatPlate& behind) {
  const Vector2d across = before.normal(), along = before.direction();
  const bool alike = along.dot(behind.direction()) > 0.0;
  double turn = 0.0;
  for (const std::size_t k : {0U, 1U}) {
    const double here = across.dot(behind.slopes[alike ? k : 1 - k] - before.slopes[k]);
    if (std::abs(here) > std::abs(turn)) turn = here;
  }
  return turn;
}

/// What a plate that turns off puts into those beside it, along z or y.
TurnedPlate turned(const FlatPlate& before, const FlatPlate& behind, double turn) {
  const bool along_z = before.across_z();
  TurnedPlate of;
  of.clear = std::max(before.clear, behind.clear);
  of.thickness = si<Length>(std::min(before.thickness, behind.thickness));
  of.yield_strength = std::min(before.yield_strength, behind.yield_strength);
  of.outstand = before.outstand || behind.outstand;
  of.between = (before.inside / before.area).value();
  of.place = si<Length>(along_z ? before.middle().x() : before.middle().y());
  of.turned = {before.force, behind.force};
  const double across = along_z ? before.normal().y() : before.normal().x();
  for (PlateForce& side : of.turned)
    for (double& per : side) per *= turn * across;
  return of;
}

/// The diaphragm that stands at a place and leads webs on; nothing where none does.
const Diaphragm* diaphragm_that_leads(const Project& project, Length s) {
  const TaperedBeam& beam = project.beam;
  for (const Diaphragm& of : beam.diaphragms)
    if (abs(of.s - s) <= 1e-6 * beam.length() && is_firm(project, of, true)) return &of;
  return nullptr;
}

/// What a diaphragm leads on of a web beside it, by its plate in shear beside its opening.
Force led_by(const Diaphragm& of, const FlatPlate& web, double gamma_M1) {
  ShearPanel panel;
  panel.depth = web.clear;
  panel.length = web.clear;  // between both webs it is hardly ever longer
  panel.thickness = of.thickness;
  panel.yield_strength = web.yield_strength;
  const double left = std::max(0.0, 1.0 - (of.opening / web.clear));
  return left * shear_resistance_of(panel, gamma_M1).resistance;
}

/// A kink and the plates of it that others may hang on.
struct Growing {
  FlangeKink kink;
  std::vector<const FlatPlate*> plates;

  bool hangs_on(const FlatPlate& of) const {
    return std::any_of(plates.begin(), plates.end(), [&](const FlatPlate* other) {
      const bool parallel = std::abs(of.normal().dot(other->direction())) <= hardly_turned;
      return parallel && std::find_first_of(of.nodes.begin(), of.nodes.end(), other->nodes.begin(),
                                            other->nodes.end()) != of.nodes.end();
    });
  }
};

constexpr double same_end = 1e-6;  // by the beam's length

/// A rigid joint of the beam's end with the end of another member of a frame.
struct Knee {
  const frame::Joint* joint = nullptr;
  const frame::Place *own = nullptr, *other = nullptr;
  Eigen::Vector3d from, to;  ///< out of it along both members, world
};

std::vector<Knee> knees_of(const Project& project) {
  std::vector<Knee> knees;
  const auto* const frame = std::get_if<frame::Structure>(&project.mechanism);
  if (frame == nullptr) return knees;
  const TaperedBeam& beam = project.beam;
  const double near = same_end * beam.length().value();
  // Out of a joint, from the end of a member that stands there.
  const auto leaves = [&](const frame::Place& at) -> std::optional<Eigen::Vector3d> {
    const frame::Member& member = frame->members[static_cast<std::size_t>(at.member)];
    const Eigen::Vector3d axis = member.axes.col(0);
    if (std::abs(at.p.x()) <= near) return axis;
    if (std::abs(at.p.x() - member.beam.length().value()) <= near) return -axis;
    return std::nullopt;
  };
  for (const frame::Joint& joint : frame->joints) {
    const bool rigid = std::all_of(joint.stiffness.begin() + 3, joint.stiffness.end(),
                                   [](double k) { return std::isinf(k); });
    const bool first = joint.a.member == project.beam_body;
    if (!rigid || joint.b.member < 0 || joint.a.member < 0 ||
        (!first && joint.b.member != project.beam_body))
      continue;
    const frame::Place &own = first ? joint.a : joint.b, &other = first ? joint.b : joint.a;
    const auto from = leaves(own), to = leaves(other);
    if (from && to) knees.push_back({&joint, &own, &other, *from, *to});
  }
  return knees;
}

void add_knees(const Project& project, std::vector<FlangeKink>& kinks) {
  const TaperedBeam& beam = project.beam;
  for (const Knee& at : knees_of(project)) {
    const Length s = at.own->p.x() > same_end * beam.length().value() ? beam.length() : Length{};
    // Straight on, what leaves on the one side goes against what leaves on the other.
    const frame::Structure& frame = std::get<frame::Structure>(project.mechanism);
    const Eigen::Matrix3d& axes = frame.members[static_cast<std::size_t>(project.beam_body)].axes;
    const Eigen::Vector3d turn = axes.transpose() * (at.from + at.to);
    const std::size_t segment = s > Length{} ? beam.segments.size() - 1 : 0;
    for (const FlatPlate& of : flat_plates_at(project, segment, s > Length{})) {
      const double across = of.normal().x() * turn.y() + of.normal().y() * turn.z();
      constexpr double straight = 1e-3;
      if (std::abs(across) < straight) continue;
      FlangeKink& knee = kinks.emplace_back();
      knee.s = s;
      knee.knee = true;
      knee.name = "the knee at " + at.joint->name + " of " + of.called;
      knee.along_z = of.across_z();
      knee.at_high = of.high;
      knee.plates.push_back(turned(of, of, across));
    }
  }
}

}  // namespace

std::array<FlangeKink::Turned, 2> FlangeKink::under(const CutForces& before,
                                                    const CutForces& behind) const {
  std::array<Turned, 2> sides;
  for (const std::size_t side : {0U, 1U}) {
    for (const TurnedPlate& plate : plates) {
      const Force force = si<Force>(stress_of(plate.turned[side], side == 0 ? before : behind));
      sides[side].force += force;
      // M_x = y F_z - z F_y.
      sides[side].couple += (along_z ? 1.0 : -1.0) * plate.place * force;
    }
  }
  return sides;
}

double FlangeKink::most_under(double force, double moment) const {
  double most = 0.0;
  for (const std::size_t side : {0U, 1U}) {
    double sum = 0.0;
    for (const TurnedPlate& plate : plates) {
      for (std::size_t k = 0; k < cut_force::count; ++k)
        sum += std::abs(plate.turned[side][k]) * (k < cut_force::T ? force : moment);
    }
    most = std::max(most, sum);
  }
  return most;
}

Length FlangeKink::width() const {
  Length widest;
  for (const TurnedPlate& of : plates)
    widest = std::max(widest, (of.outstand ? 2.0 : 1.0) * of.clear);
  return widest;
}

std::vector<FlangeKink> flange_kinks_of(const Project& project) {
  std::vector<FlangeKink> kinks;
  for (std::size_t k = 0; k + 1 < project.beam.segments.size(); ++k) {
    const std::vector<FlatPlate> before = flat_plates_at(project, k, true),
                                 behind = flat_plates_at(project, k + 1, false);
    std::vector<Growing> here;
    for (const FlatPlate& of : before) {
      const auto next = going_on(of, behind);
      // Where it does not go on `flange_steps_of` has it.
      if (!goes_on(of, next)) continue;
      constexpr double straight = 1e-6;
      const double turn = turn_of(of, *next.first);
      if (std::abs(turn) < straight) continue;
      auto at = std::find_if(here.begin(), here.end(),
                             [&](const Growing& other) { return other.hangs_on(of); });
      if (at == here.end()) {
        at = here.insert(here.end(), Growing{});
        at->kink.s = project.beam.segments[k].end();
        at->kink.name = "the kink of " + of.called;
        at->kink.along_z = of.across_z();
        at->kink.at_high = of.high;
      } else {
        at->kink.name += " and " + of.called;
      }
      at->kink.plates.push_back(turned(of, *next.first, turn));
      at->plates.push_back(&of);
    }
    for (Growing& of : here) kinks.push_back(std::move(of.kink));
  }
  add_knees(project, kinks);
  return kinks;
}

std::vector<std::string> judged_knees_of(const Project& project) {
  std::vector<std::string> names;
  for (const Knee& at : knees_of(project)) {
    const auto& members = std::get<frame::Structure>(project.mechanism).members;
    const frame::Member &own = members[static_cast<std::size_t>(at.own->member)],
                        &other = members[static_cast<std::size_t>(at.other->member)];
    const auto end_of = [](const frame::Member& member, const frame::Place& place) {
      const bool at_start = place.p.x() < 0.5 * member.beam.length().value();
      return section_at(member.beam, {at_start ? Length{} : member.beam.length(),
                                      at_start ? Side::behind : Side::before})
          .outer;
    };
    const Profile mine = end_of(own, *at.own), its = end_of(other, *at.other);
    if (mine.index() != its.index()) continue;
    const Extent one = extent_of(mine), two = extent_of(its);
    const double size = std::max(one.z_high - one.z_low, one.y_high - one.y_low).value();
    const auto alike = [&](Length a, Length b) { return std::abs((a - b).value()) < 1e-3 * size; };
    // As deep in the plane of the knee and as wide across it, with the same axis across it.
    const bool turned = std::abs(own.axes.col(1).dot(other.axes.col(1))) > 1.0 - 1e-6 ||
                        std::abs(own.axes.col(2).dot(other.axes.col(2))) > 1.0 - 1e-6;
    if (turned && alike(one.z_high - one.z_low, two.z_high - two.z_low) &&
        alike(one.y_high - one.y_low, two.y_high - two.y_low))
      names.push_back(at.joint->name);
  }
  return names;
}

std::vector<FlangeStep> flange_steps_of(const Project& project) {
  const TaperedBeam& beam = project.beam;
  std::vector<FlangeStep> steps;
  for (std::size_t k = 0; k + 1 < beam.segments.size(); ++k) {
    const std::array sides{flat_plates_at(project, k, true), flat_plates_at(project, k + 1, false)};
    const Length s = beam.segments[k].end();
    const Diaphragm* const diaphragm = diaphragm_that_leads(project, s);
    for (const std::size_t side : {0U, 1U}) {
      std::array<double, 2> areas{};  // of the plates across z, and of the others
      for (const FlatPlate& of : sides[side]) areas[of.across_z() ? 0 : 1] += of.area.value();
      for (const FlatPlate& of : sides[side]) {
        const bool web = !of.across_z();
        const auto next = going_on(of, sides[1 - side]);
        if (goes_on(of, next)) continue;
        if (next.first == nullptr && stands_on_one(of, sides[1 - side])) continue;
        FlangeStep& step = steps.emplace_back();
        step.s = s;
        step.name = of.name;
        step.web = web;
        step.area = of.area;
        step.yield_strength = of.yield_strength;
        if (web && diaphragm != nullptr)
          step.led = led_by(*diaphragm, of, project.strength.gamma_M1);
        step.along = {of.force, of.halves[0], of.halves[1]};
        step.across[web ? cut_force::V_z : cut_force::V_y] = of.area.value() / areas[web ? 1 : 0];
        if (next.first != nullptr) step.by = si<Length>(next.second);
      }
    }
  }
  return steps;
}

std::vector<PlateStep> plate_steps_at(const Project& project, std::size_t segment) {
  // What rounding of units makes is no step.
  constexpr double least = 1e-6;
  std::vector<PlateStep> steps;
  const std::vector<FlatPlate> behind = flat_plates_at(project, segment + 1, false);
  for (const FlatPlate& of : flat_plates_at(project, segment, true)) {
    const auto next = going_on(of, behind);
    if (!goes_on(of, next) || std::abs(of.thickness - next.first->thickness) <= least) continue;
    const bool in_path =
        std::holds_alternative<ThinWalled>(project.beam.segments[segment].to.outer);
    steps.push_back({of.name, !of.across_z(), in_path, si<Length>(of.thickness),
                     si<Length>(next.first->thickness)});
  }
  return steps;
}

std::vector<Patch> PatchSearch::kinks_under(const CutForceDiagram& diagram) const {
  std::vector<Patch> patches;
  std::vector<double> uses;
  patches.reserve(kinks_.size());
  uses.reserve(kinks_.size());
  for (const FlangeKink& of : kinks_) {
    // At an end of the beam both are those of its own side.
    const bool at_start = of.s == Length{}, at_end = of.s == project_->beam.length();
    const CutForces before = diagram.at({of.s, at_start ? Side::behind : Side::before}),
                    behind = diagram.at({of.s, at_end ? Side::before : Side::behind});
    std::array<FlangeKink::Turned, 2> sides = of.under(before, behind);
    // Each of both beams of a knee takes half of it.
    for (FlangeKink::Turned& side : sides) {
      side.force *= of.knee ? 0.5 : 1.0;
      side.couple *= of.knee ? 0.5 : 1.0;
    }
    const FlangeKink::Turned& turned = sides[abs(sides[1].force) > abs(sides[0].force) ? 1 : 0];
    Patch& patch = patches.emplace_back();
    patch.name = of.name;
    patch.s = of.s;
    patch.along_z = of.along_z;
    patch.force = turned.force;
    patch.couple = turned.couple;
    patch.kink = &of;
    patch.by_sides = sides;
    patch.at_high = of.at_high;
    patch.hangs = (turned.force > Force{}) == of.at_high;
    uses.push_back(use_across_kink(of, before, behind));
  }
  // A curve drawn as many kinks bends the plate as one of all their turns.
  for (Patch& patch : patches) {
    for (std::size_t k = 0; k < kinks_.size(); ++k) {
      const FlangeKink& other = kinks_[k];
      if (other.along_z == patch.along_z && other.at_high == *patch.at_high &&
          abs(other.s - patch.s) <= patch.kink->width())
        patch.bent += uses[k];
    }
  }
  std::erase_if(patches, [](const Patch& of) { return of.is_none(); });
  return patches;
}

double use_across_kink(const FlangeKink& kink, const CutForces& before, const CutForces& behind) {
  constexpr double nu = 0.3;
  double use = 0.0;
  for (const TurnedPlate& of : kink.plates) {
    const double force = of.between * std::max(std::abs(stress_of(of.turned[0], before)),
                                               std::abs(stress_of(of.turned[1], behind)));
    const double m = of.outstand ? bent_outside
                                 : (1.0 + nu) * boost::math::constants::catalan<double>() /
                                       (std::numbers::pi * std::numbers::pi);
    const double t = of.thickness.value();
    use = std::max(use, 6.0 * m * force / (t * t) / of.yield_strength.value());
  }
  return use;
}

}  // namespace boxbeam
