#include "boxbeam/verification/slow_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"

namespace boxbeam {
namespace {

/// A contact over the states of a motion.
struct Course {
  std::vector<double> full;   ///< mu P [N]
  std::vector<double> share;  ///< of it that acts
  double fastest = 0.0;       ///< [m/s]
};

Course course_of(planar::FrictionContact contact, const planar::Motion& motion) {
  contact.law.viscous = 0.0;
  Course course;
  for (const planar::State& state : motion.states) {
    const double velocity = planar::sliding_velocity_of(contact, state.q, state.v);
    course.fastest = std::max(course.fastest, std::abs(velocity));
    // At an infinite velocity all of it acts.
    constexpr double fast = 1e9;
    course.full.push_back(
        std::abs(planar::friction_force_of(contact, state.lambda, fast * contact.law.creep)));
    course.share.push_back(std::abs(velocity) / std::hypot(velocity, contact.law.creep));
  }
  return course;
}

/// Of what acts at three times the creep velocity.
const double slow = 3.0 / std::sqrt(10.0);

/// Largest nominal stress along the beam at each state [Pa].
std::vector<double> stresses_of(const Project& project, const SituationRun& run,
                                std::size_t states) {
  const std::vector<ComparedPlace> places = compared_places_of(project.beam);
  std::vector<double> stresses;
  for (std::size_t i = 0; i < states; ++i)
    stresses.push_back(fibre_stresses(run.loads.even_diagram(i), places).abs().maxCoeff());
  return stresses;
}

/// What the friction may be in stretches of slow states, each longer than a tenth of the motion, in
/// which the beam bears more than where the contact slides just before and behind, and much [N].
double unseen_in_long_stretches(const Course& course, const std::vector<double>& stresses,
                                bool closed) {
  constexpr double more = 1.02, much = 0.7;
  const std::size_t n = course.share.size();
  const auto is_slow = [&](std::size_t i) { return course.share[i % n] < slow; };
  const double largest = *std::max_element(stresses.begin(), stresses.end());
  double unseen = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_slow(i) || (i > 0 ? is_slow(i - 1) : closed && is_slow(n - 1))) continue;
    std::size_t end = i + 1;
    while (end < (closed ? i + n : n) && is_slow(end)) ++end;
    if (10 * (end - i) <= n) continue;
    double beside = 0.0, within = 0.0, full = 0.0;
    if (i > 0 || closed) beside = stresses[(i + n - 1) % n];
    if (end < n || closed) beside = std::max(beside, stresses[end % n]);
    for (std::size_t k = i; k < end; ++k) {
      within = std::max(within, stresses[k % n]);
      full = std::max(full, course.full[k % n]);
    }
    if (within > more * beside && within >= much * largest) unseen = std::max(unseen, full);
  }
  return unseen;
}

std::string said_of(const Project& project, const SituationRun& run,
                    const planar::FrictionContact& contact) {
  constexpr double counts = 0.9, bears = 0.01;
  const planar::Motion& motion = planar_motion_of(run);
  const Course course = course_of(contact, motion);
  const double full = *std::max_element(course.full.begin(), course.full.end());
  if (!(full > bears * run.loads.largest_force())) return "";
  double acting = 0.0;
  for (std::size_t i = 0; i < course.full.size(); ++i)
    acting = std::max(acting, course.full[i] * course.share[i]);
  if (acting < counts * full) {
    if (motion.freedom.undriven > 0)
      return fmt::format(
          "forces move it with at most {:.3g} mm/s (creep {:.3g} mm/s), at most "
          "{:.2g} of {:.3g} kN act, and it does not stick",
          1e3 * course.fastest, 1e3 * contact.law.creep, 1e-3 * acting, 1e-3 * full);
    if (course.fastest < 1e-3 * contact.law.creep)
      return fmt::format("it stands, and up to {:.3g} kN in either sense are not looked at",
                         1e-3 * full);
    return fmt::format(
        "at most {:.2g} of {:.3g} kN act, for it slides with at most {:.3g} mm/s "
        "(creep {:.3g} mm/s), or more slowly where it presses most",
        1e-3 * acting, 1e-3 * full, 1e3 * course.fastest, 1e3 * contact.law.creep);
  }
  if (motion.freedom.undriven > 0) return "";
  const double unseen = unseen_in_long_stretches(
      course, stresses_of(project, run, course.share.size()), motion.closed);
  if (!(unseen > bears * run.loads.largest_force())) return "";
  return fmt::format("while it stands up to {:.3g} kN in either sense are not looked at",
                     1e-3 * unseen);
}

}  // namespace

std::vector<NotJudged> slow_friction_of(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  std::vector<NotJudged> found;
  if (!std::holds_alternative<planar::Mechanism>(project.mechanism)) return found;
  for (const SituationRun& run : runs) {
    const planar::Mechanism& mechanism = planar_in(project, *run.situation);
    for (const planar::FrictionContact& contact : planar::friction_contacts_of(mechanism)) {
      if (contact.law.coulomb == 0.0) continue;
      const std::string& joint = mechanism.joints[static_cast<std::size_t>(contact.joint)].name;
      const std::string what = "dry friction of " + joint;
      if (std::any_of(found.begin(), found.end(),
                      [&](const NotJudged& of) { return of.what == what; }))
        continue;
      const std::string said = said_of(project, run, contact);
      if (!said.empty()) found.push_back({Criterion::yield, what, said});
    }
  }
  return found;
}

}  // namespace boxbeam
