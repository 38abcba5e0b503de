// What holds for every frame, tapered as it may be: reciprocity, balance, superposition, and that
// neither the axes of the world nor the division into members and segments matter.
#include "boxbeam/mechanism/frame/statics.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <tuple>

#include "catch.hpp"
#include "support/frame_by_stiffness.hpp"
#include "support/frame_differences.hpp"
#include "support/property.hpp"
#include "support/random_frame.hpp"
#include "support/rest_frame.hpp"

namespace frame_statics_test {

using namespace boxbeam;
using namespace boxbeam::frame;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr int cases = 50;

/// Points that are forced, pushed as far as they go, and the size of what was summed.
struct Work {
  double sum = 0.0, size = 0.0;
  void add(double part) {
    sum += part;
    size += std::abs(part);
  }
};

Work work_of(const ActingLoads& loads, const Statics& statics, const Equilibrium& at) {
  Work work;
  for (const auto& load : loads.points) {
    const Place& place = load.action.at;
    const Vector6 motion = statics.motion_at(place.member, place.p.x(), at);
    const Matrix3d& axes = statics.structure().members[static_cast<std::size_t>(place.member)].axes;
    const Vector3d arm = axes * Vector3d(0.0, place.p.y(), place.p.z());
    const Vector3d turn = motion.tail<3>();
    work.add(load.action.force.dot(motion.head<3>() + turn.cross(arm)));
    work.add(load.action.moment.dot(turn));
  }
  return work;
}

ActingLoads forces_on(const test::RandomFrame& frame) {
  const test::Dice dice;
  ActingLoads loads;
  for (int k = 0; k < 3; ++k) {
    const int member = dice.upto(static_cast<int>(frame.of.members.size()) - 1);
    const auto number = [&] { return dice.between(-1e4, 1e4); };
    const bool plane = frame.of.plane;
    const Vector3d force(number(), number(), plane ? 0.0 : number());
    const Vector3d moment(plane ? 0.0 : number(), plane ? 0.0 : number(), number());
    loads.points.push_back({"", {frame.place_on(member), force, moment}});
  }
  return loads;
}

TEST_CASE("what one load does along another, that does along the first", "[frame]") {
  // Betti.
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const Statics statics(frame.of);
        const ActingLoads one = forces_on(frame), other = forces_on(frame);
        const Equilibrium under_one = statics.solve(one), under_other = statics.solve(other);
        const double there = work_of(one, statics, under_other).sum;
        const double back = work_of(other, statics, under_one).sum;
        const double size = std::sqrt(work_of(one, statics, under_one).size *
                                      work_of(other, statics, under_other).size);
        RC_ASSERT(std::abs(there - back) <= 1e-10 * size);
      },
      cases);
}

TEST_CASE("a joint's force under a load is the load's path when the joint is shifted", "[frame]") {
  // Mueller-Breslau: F u(s) = -r(F) s.
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const Statics statics(frame.of);
        const ActingLoads load = forces_on(frame);
        const Equilibrium loaded = statics.solve(load);
        for (std::size_t j = 0; j < frame.of.joints.size(); ++j) {
          ActingLoads shifted;
          const bool plane = frame.of.plane;
          shifted.settlements.push_back({static_cast<int>(j),
                                         {0.003, -0.002, plane ? 0.0 : 0.001},
                                         {plane ? 0.0 : 0.001, plane ? 0.0 : 0.002, -0.003}});
          const Work path = work_of(load, statics, statics.solve(shifted));
          Vector6 shift;
          shift << shifted.settlements[0].shift, shifted.settlements[0].turn;
          const Vector6 parts = loaded.joints[j].cwiseProduct(shift);
          RC_ASSERT(std::abs(path.sum + parts.sum()) <=
                    1e-9 * (path.size + parts.cwiseAbs().sum()) + 1e-9);
        }
      },
      cases);
}

TEST_CASE("along a load heat moves by what the load strains", "[frame]") {
  // F u(e) = int c(F) e ds, e the strains of heat.
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const Statics statics(frame.of);
        const ActingLoads load = forces_on(frame);
        const Equilibrium loaded = statics.solve(load);
        ActingLoads warm;
        warm.heat.push_back({0, 30.0, frame.of.plane ? 0.0 : 120.0, -80.0});
        const Work path = work_of(load, statics, statics.solve(warm));
        const double alpha = frame.of.members[0].expansion;
        Work strained;
        for (const CutForcePiece& piece : loaded.members[0].cut.pieces) {
          const double length = piece.length.value();
          strained.add(alpha * warm.heat[0].mean * integral_of(piece.N)(length));
          strained.add(alpha * warm.heat[0].along_z * integral_of(piece.M_y)(length));
          strained.add(-alpha * warm.heat[0].along_y * integral_of(piece.M_z)(length));
        }
        RC_ASSERT(std::abs(path.sum - strained.sum) <= 1e-9 * (path.size + strained.size) + 1e-9);
      },
      cases);
}

TEST_CASE("every member is in balance, and the whole on its supports", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const Statics statics(frame.of);
        const ActingLoads loads = frame.loads();
        const Equilibrium at = statics.solve(loads);
        Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();
        double size = 1.0;
        const auto add = [&](const Vector3d& place, const Vector3d& f, const Vector3d& m) {
          force += f;
          moment += m + place.cross(f);
          size = std::max({size, f.norm(), m.norm(), place.cross(f).norm()});
        };
        for (std::size_t m = 0; m < at.members.size(); ++m) {
          const Member& member = frame.of.members[m];
          double on_member = 1.0;
          for (const PointLoad& load : at.members[m].loads.points) {
            const double reach = 1.0 + load.s.value();
            on_member = std::max({on_member, reach * load.force.norm(), load.moment.norm()});
          }
          const Imbalance open = imbalance_of(at.members[m].loads);
          if (member.beam.density.value() > 0.0) {
            const double weight = mass_properties_of(member.beam).mass.value() * 9.81;
            on_member = std::max(on_member, weight * member.beam.length().value());
          }
          RC_ASSERT(open.force.norm() < 1e-11 * on_member);
          RC_ASSERT(open.moment.norm() < 1e-11 * on_member);
          if (loads.weight != 0.0 && member.beam.density.value() > 0.0) {
            const MassProperties mass = mass_properties_of(member.beam);
            add(member.start + member.axes.col(0) * mass.centre.value(),
                loads.weight * mass.mass.value() * frame.of.gravity, Vector3d::Zero());
          }
        }
        for (std::size_t j = 0; j < at.joints.size(); ++j) {
          const Joint& joint = frame.of.joints[j];
          if (joint.b.member != ground) continue;
          add(in_world(frame.of, joint.a), at.joints[j].head<3>(), at.joints[j].tail<3>());
        }
        for (const auto& load : loads.points)
          add(in_world(frame.of, load.action.at), load.action.force, load.action.moment);
        for (const LineAction& line : loads.lines) {
          // A rectangle and a triangle.
          const double length = line.to - line.from;
          const auto at_part = [&](double part) {
            return in_world(frame.of, {line.member, {line.from + part * length, 0.0, 0.0}});
          };
          add(at_part(0.5), length * line.at_from, Vector3d::Zero());
          add(at_part(2.0 / 3.0), 0.5 * length * (line.at_to - line.at_from), Vector3d::Zero());
        }
        RC_ASSERT(force.norm() < 1e-11 * size);
        RC_ASSERT(moment.norm() < 1e-11 * size);
      },
      cases);
}

/// Stations of a member, off the places where something jumps.
template <class Compare>
void along(const Member& member, const Compare& compare) {
  const double length = member.beam.length().value();
  for (int k = 0; k <= 20; ++k) compare(length * (k + 0.1234567) / 21.0);
}

TEST_CASE("loads superpose", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const Statics statics(frame.of);
        const ActingLoads one = frame.loads(), other = frame.loads();
        ActingLoads both = one;
        both.weight -= 2.5 * other.weight;
        for (auto load : other.points) {
          load.action.force *= -2.5;
          load.action.moment *= -2.5;
          both.points.push_back(load);
        }
        for (LineAction line : other.lines) {
          line.at_from *= -2.5;
          line.at_to *= -2.5;
          both.lines.push_back(line);
        }
        for (const HeatAction& heat : other.heat)
          both.heat.push_back(
              {heat.member, -2.5 * heat.mean, -2.5 * heat.along_y, -2.5 * heat.along_z});
        for (const Settlement& of : other.settlements)
          both.settlements.push_back({of.joint, -2.5 * of.shift, -2.5 * of.turn});
        const Equilibrium a = statics.solve(one), b = statics.solve(other), c = statics.solve(both);
        test::Differences cuts(1e3), motions(1e-5);
        for (std::size_t m = 0; m < frame.of.members.size(); ++m) {
          along(frame.of.members[m], [&](double s) {
            const int i = static_cast<int>(m);
            cuts.add(test::cut_at(c, i, s, Side::both),
                     test::cut_at(a, i, s, Side::both) - 2.5 * test::cut_at(b, i, s, Side::both));
            motions.add(statics.motion_at(i, s, c),
                        statics.motion_at(i, s, a) - 2.5 * statics.motion_at(i, s, b));
          });
        }
        RC_ASSERT(cuts.largest() < 1e-10);
        RC_ASSERT(motions.largest() < 1e-10);
      },
      cases);
}

TEST_CASE("a frame turned and shifted with its loads is cut alike", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(false, true);
        const ActingLoads loads = frame.loads();
        const Matrix3d R = Eigen::AngleAxisd(test::Dice().between(-3.0, 3.0),
                                             Vector3d(0.3, -0.5, 0.8).normalized())
                               .toRotationMatrix();
        const Vector3d shift(12.0, -7.0, 3.0);
        Structure turned = frame.of;
        turned.gravity = R * turned.gravity;
        for (Member& member : turned.members) {
          member.start = R * member.start + shift;
          member.axes = R * member.axes;
        }
        for (Joint& joint : turned.joints) {
          joint.axes = R * joint.axes;
          if (joint.b.member == ground) joint.b.p = R * joint.b.p + shift;
        }
        ActingLoads with = loads;
        for (auto& load : with.points) {
          load.action.force = R * load.action.force;
          load.action.moment = R * load.action.moment;
        }
        for (LineAction& line : with.lines) {
          line.at_from = R * line.at_from;
          line.at_to = R * line.at_to;
        }
        for (Settlement& settlement : with.settlements) {
          settlement.shift = R * settlement.shift;
          settlement.turn = R * settlement.turn;
        }
        const Statics here(frame.of), there(turned);
        const Equilibrium a = here.solve(loads), b = there.solve(with);
        test::Differences cuts(1e3), motions(1e-5);
        for (std::size_t m = 0; m < frame.of.members.size(); ++m) {
          along(frame.of.members[m], [&](double s) {
            const int i = static_cast<int>(m);
            cuts.add(test::cut_at(b, i, s, Side::both), test::cut_at(a, i, s, Side::both));
            const Vector6 motion = here.motion_at(i, s, a);
            Vector6 expected;
            expected << R * motion.head<3>(), R * motion.tail<3>();
            motions.add(there.motion_at(i, s, b), expected);
          });
        }
        RC_ASSERT(cuts.largest() < 1e-10);
        RC_ASSERT(motions.largest() < 1e-10);
      },
      cases);
}

/// Both alike in all members of the first; a station of it stands elsewhere in the other.
template <class There>
void check_alike(const Structure& of, const ActingLoads& loads, const Structure& other,
                 const ActingLoads& with, const There& there) {
  const Statics one(of), two(other);
  const Equilibrium a = one.solve(loads), b = two.solve(with);
  test::Differences cuts(1e3), motions(1e-5);
  for (std::size_t m = 0; m < of.members.size(); ++m) {
    along(of.members[m], [&](double s) {
      const int i = static_cast<int>(m);
      const auto [member, station] = there(i, s);
      cuts.add(test::cut_at(b, member, station, Side::both), test::cut_at(a, i, s, Side::both));
      motions.add(two.motion_at(member, station, b), one.motion_at(i, s, a));
    });
  }
  RC_ASSERT(cuts.largest() < 1e-9);
  RC_ASSERT(motions.largest() < 1e-9);
}

TEST_CASE("a plane frame is a frame in space that is held in its plane", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(true, true);
        Structure space = frame.of;
        space.plane = false;
        for (Joint& joint : space.joints) {
          for (const std::size_t out_of_it : {2u, 3u, 4u}) joint.stiffness[out_of_it] = test::rigid;
        }
        const ActingLoads loads = frame.loads();
        check_alike(frame.of, loads, space, loads, [](int member, double s) {
          return std::pair{member, s};
        });
      },
      cases);
}

void split_segment(TaperedBeam& beam, double s) {
  const std::size_t k = segment_at(beam, {si<Length>(s)});
  Segment& first = beam.segments[k];
  Segment second = first;
  first.length = si<Length>(s) - first.start;
  second.start = si<Length>(s);
  second.length = second.length - first.length;
  first.to = second.from =
      interpolate(first.from, first.to, first.length / (first.length + second.length));
  beam.segments.insert(beam.segments.begin() + static_cast<std::ptrdiff_t>(k) + 1, second);
}

TEST_CASE("a segment in two halves is the segment", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        Structure halved = frame.of;
        for (Member& member : halved.members) {
          const Segment first = member.beam.segments[0];
          split_segment(member.beam, 0.5 * first.length.value());
        }
        const ActingLoads loads = frame.loads();
        check_alike(frame.of, loads, halved, loads, [](int member, double s) {
          return std::pair{member, s};
        });
      },
      cases);
}

TEST_CASE("a member in two that are joined rigidly is the member", "[frame]") {
  test::holds(
      [] {
        const test::RandomFrame frame(test::Dice().one_in(3), true);
        const ActingLoads loads = frame.loads();
        Structure of = frame.of;
        ActingLoads with = loads;
        const double length = of.members[0].beam.length().value(), s = 0.5123456 * length;
        const int added = static_cast<int>(of.members.size());
        split_segment(of.members[0].beam, s);
        Member rest = of.members[0];
        rest.start += s * rest.axes.col(0);
        const auto is_behind = [s](const Segment& segment) { return segment.start.value() >= s; };
        std::erase_if(of.members[0].beam.segments, is_behind);
        std::erase_if(rest.beam.segments,
                      [&](const Segment& segment) { return !is_behind(segment); });
        for (Segment& segment : rest.beam.segments) segment.start -= si<Length>(s);
        of.members.push_back(rest);
        const auto there = [&](int member, double at) {
          return member == 0 && at > s ? std::pair{added, at - s} : std::pair{member, at};
        };
        const auto move = [&](Place& place) {
          std::tie(place.member, place.p.x()) = there(place.member, place.p.x());
        };
        for (Joint& joint : of.joints) {
          move(joint.a);
          move(joint.b);
        }
        Joint joint;
        joint.a = {0, {s, 0.0, 0.0}};
        joint.b = {added, Vector3d::Zero()};
        joint.stiffness.fill(test::rigid);
        of.joints.push_back(joint);
        for (auto& load : with.points) move(load.action.at);
        std::vector<LineAction> lines;
        for (const LineAction& line : with.lines) {
          const double part = std::clamp((s - line.from) / (line.to - line.from), 0.0, 1.0);
          const Vector3d between = line.at_from + part * (line.at_to - line.at_from);
          if (line.member != 0 || line.to <= s)
            lines.push_back(line);
          else if (line.from >= s)
            lines.push_back({added, line.from - s, line.to - s, line.at_from, line.at_to});
          else {
            lines.push_back({0, line.from, s, line.at_from, between});
            lines.push_back({added, 0.0, line.to - s, between, line.at_to});
          }
        }
        with.lines = lines;
        const std::vector<HeatAction> heat = with.heat;
        for (HeatAction of_both : heat) {
          if (of_both.member != 0) continue;
          of_both.member = added;
          with.heat.push_back(of_both);
        }
        check_alike(frame.of, loads, of, with, there);
      },
      cases);
}

}  // namespace

}  // namespace frame_statics_test
