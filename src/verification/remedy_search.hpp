#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "boxbeam/project/plate_keys.hpp"
#include "boxbeam/verification/verify.hpp"

/// What the searches of remedies have in common.
namespace boxbeam {

/// The largest utilisation of a case that passes; nothing where it does not.
using Outcome = std::optional<double>;

/// A candidate that passes, by its number.
struct Passing {
  std::size_t candidate = 0;
  double utilisation = 0.0;
};

/// The first of candidates, from weak to strong, that passes, where the last one does.
std::optional<Passing> first_passing(std::size_t count,
                                     const std::function<Outcome(std::size_t)>& outcome);

/// The search for one case.
struct RemedySearch {
  const Project& project;
  std::deque<SituationRun>& runs;
  const Verification& verification;
  const CheckResult& governing;
  Remedies remedies = {};

  std::size_t segment() const { return segment_at(project.beam, governing.check.station); }
  const Profile& profile() const { return project.beam.segments[segment()].from.outer; }

  /// Whether other plates change how the mechanism moves, which is not looked at.
  bool is_elastic() const;

  /// The copy is judged under the loads that are there, whose situations it takes over.
  Outcome judged(const Project& copy) const;

  /// The case with these keys, read anew; nothing where it cannot be.
  std::optional<Project> changed_by(const std::vector<std::string>& set) const;

  /// A case that cannot be analysed does not pass.
  static Outcome verified(const Project& changed);
};

/// Thicker plates of the governing segment.
void look_at_plates(RemedySearch& search, PlateGroup group);

/// Diaphragms at equal distances: in the panel of the governing place, else all along the beam.
void look_at_diaphragms(RemedySearch& search);

/// The diaphragm that takes the governing force, thicker.
void look_at_diaphragm(RemedySearch& search);

/// Flats along the plates that buckle at the governing place.
void look_at_stiffeners(RemedySearch& search);

}  // namespace boxbeam
