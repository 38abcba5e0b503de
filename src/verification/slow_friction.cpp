#include "boxbeam/verification/slow_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "boxbeam/mechanism/planar/forces.hpp"
#include "boxbeam/mechanism/planar/motion.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/verification/vibrating_stress.hpp"
#include "front_ends.hpp"

namespace boxbeam {
namespace {

/// A contact over the even instants of a motion.
struct Course {
  std::string joint;
  Friction law;
  std::vector<double> full;   ///< mu P [N]
  std::vector<double> share;  ///< of it that acts
  double fastest = 0.0;       ///< [m/s]
  double couple = 0.0;        ///< largest that presses nowhere, in space [N m]
  double presses_with = 0.0;  ///< mu times what it presses with at least [N]

  void add(double pressure, double velocity) {
    fastest = std::max(fastest, std::abs(velocity));
    full.push_back(law.coulomb * pressure);
    // Of what sticks all that Coulomb's law says.
    share.push_back(can_stick(law) ? 1.0 : std::abs(velocity) / std::hypot(velocity, law.creep));
  }

  /// What it may take where it stands, by what it takes sliding.
  double standing() const { return static_coefficient_of(law) / law.coulomb; }
};

/// The contacts with dry friction of a situation.
struct Courses {
  std::vector<Course> of;
  bool forced = false;  ///< forces decide the motion
  bool closed = false;  ///< it repeats
};

Courses courses_of(const planar::Mechanism& mechanism, const SituationRun& run) {
  const planar::Motion& motion = planar_motion_of(run);
  Courses courses{{}, motion.freedom.undriven > 0, motion.closed};
  for (const planar::FrictionContact& contact : planar::friction_contacts_of(mechanism)) {
    if (contact.law.coulomb == 0.0) continue;
    Course& course = courses.of.emplace_back();
    course.joint = mechanism.joints[static_cast<std::size_t>(contact.joint)].name;
    course.law = contact.law;
    for (const planar::State& state : motion.states) {
      course.add(planar::pressure_on(contact, state.lambda),
                 planar::sliding_velocity_of(contact, state.q, state.v));
    }
  }
  return courses;
}

/// Without contacts whose friction a drive takes: of them the beam feels nothing.
Courses courses_of(const spatial::Mechanism& mechanism, const SituationRun& run) {
  const spatial::Chain& chain = chain_of(run);
  const LoadSpan span = span_of_motion_in_space(run);
  Courses courses{{}, chain.forced() != nullptr, span.closed};
  std::vector<spatial::FrictionContact> contacts;
  for (const spatial::FrictionContact& contact : chain.contacts()) {
    if (contact.law.coulomb == 0.0 || spatial::is_taken_by_drive(mechanism, contact)) continue;
    contacts.push_back(contact);
    Course& course = courses.of.emplace_back();
    course.joint = spatial::name_of_contact(mechanism, contact);
    course.law = contact.law;
  }
  if (contacts.empty()) return courses;
  spatial::State state;
  std::vector<spatial::Wrench> joints;
  for (std::size_t k = 0; k < span.instants; ++k) {
    chain.at(
        (span.begin + span.period * (static_cast<double>(k) / static_cast<double>(span.instants)))
            .value(),
        state);
    chain.joint_wrenches(state, joints);
    for (std::size_t j = 0; j < contacts.size(); ++j) {
      Course& course = courses.of[j];
      const GuideLoad load = spatial::guide_load_of(mechanism, contacts[j], state, joints);
      course.add(pressure_of(course.law, load),
                 spatial::sliding_velocity_of(mechanism, contacts[j], state));
      const double about = spatial::couple_about_guide(mechanism, contacts[j], state, joints);
      const double tilting = course.law.guide > 0.0 ? 0.0 : load.tail<3>().norm();
      course.couple = std::max(course.couple, std::hypot(about, tilting));
    }
  }
  // No guide is longer, or wider, than the mechanism.
  for (Course& course : courses.of)
    course.presses_with = 2.0 * course.law.coulomb * course.couple / spatial::size_of(mechanism);
  return courses;
}

Courses courses_of(const Project& project, const SituationRun& run) {
  if (std::holds_alternative<planar::Mechanism>(project.mechanism))
    return courses_of(planar_in(project, *run.situation), run);
  if (std::holds_alternative<spatial::Mechanism>(project.mechanism))
    return courses_of(spatial_in(project, *run.situation), run);
  return {};
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

/// What its velocity takes away of it.
std::string velocity_text(const Project& project, const SituationRun& run, const Courses& courses,
                          const Course& course) {
  constexpr double counts = 0.9, bears = 0.01;
  const double full = *std::max_element(course.full.begin(), course.full.end());
  if (!(full > bears * run.loads.largest_force())) return "";
  double acting = 0.0;
  for (std::size_t i = 0; i < course.full.size(); ++i)
    acting = std::max(acting, course.full[i] * course.share[i]);
  if (can_stick(course.law)) return "";
  const double standing = course.standing();
  if (acting < counts * full) {
    if (courses.forced)
      return fmt::format(
          "forces move it with at most {:.3g} mm/s (creep {:.3g} mm/s), at most "
          "{:.2g} of {:.3g} kN act, and it does not stick",
          1e3 * course.fastest, 1e3 * course.law.creep, 1e-3 * acting, 1e-3 * full);
    if (course.fastest < 1e-3 * course.law.creep)
      return fmt::format("it stands, and up to {:.3g} kN in either sense are not looked at",
                         1e-3 * standing * full);
    return fmt::format(
        "at most {:.2g} of {:.3g} kN act, for it slides with at most {:.3g} mm/s "
        "(creep {:.3g} mm/s), or more slowly where it presses most",
        1e-3 * acting, 1e-3 * full, 1e3 * course.fastest, 1e3 * course.law.creep);
  }
  if (standing > 1.0) {
    return fmt::format(
        "where it stands or turns round up to {:.3g} kN may act in either sense, and no more than "
        "{:.3g} kN are looked at",
        1e-3 * standing * full, 1e-3 * full);
  }
  if (courses.forced) return "";
  const double unseen = unseen_in_long_stretches(
      course, stresses_of(project, run, course.share.size()), courses.closed);
  if (!(unseen > bears * run.loads.largest_force())) return "";
  return fmt::format("while it stands up to {:.3g} kN in either sense are not looked at",
                     1e-3 * unseen);
}

/// What presses nowhere.
std::string couple_text(const SituationRun& run, const Course& course) {
  constexpr double bears = 0.01;
  if (!(course.presses_with > bears * run.loads.largest_force())) return "";
  return fmt::format(
      "a couple of up to {:.3g} kN m {} presses nowhere", 1e-3 * course.couple,
      course.law.guide > 0.0 ? "about its guide" : "on its guide, which has no guide_length,");
}

std::string said_of(const Project& project, const SituationRun& run, const Courses& courses,
                    const Course& course) {
  const std::string couple = couple_text(run, course);
  const std::string velocity = velocity_text(project, run, courses, course);
  return couple + (couple.empty() || velocity.empty() ? "" : "; ") + velocity;
}

}  // namespace

std::vector<NotJudged> slow_friction_of(const Project& project,
                                        const std::deque<SituationRun>& runs) {
  std::vector<NotJudged> found;
  for (const SituationRun& run : runs) {
    const Courses courses = courses_of(project, run);
    for (const Course& course : courses.of) {
      const std::string what = "dry friction of " + course.joint;
      if (std::any_of(found.begin(), found.end(),
                      [&](const NotJudged& of) { return of.what == what; }))
        continue;
      const std::string said = said_of(project, run, courses, course);
      if (!said.empty()) found.push_back({Criterion::yield, what, said});
    }
  }
  return found;
}

}  // namespace boxbeam
