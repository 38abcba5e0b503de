#pragma once

#include <deque>
#include <map>
#include <string>

#include "boxbeam/project/project.hpp"
#include "boxbeam/verification/check.hpp"
#include "boxbeam/verification/situation_run.hpp"
#include "random_case.hpp"

/// The largest utilisation of every criterion by looking everywhere: slow, without any search.
///
/// It has of its own: which stations (a dense grid and, on both sides, every place where anything
/// jumps or bends), which instants, which places of the section; the stresses there
/// (section_stress.hpp); which detail, plate and weld hold where; how the cycles of the situations
/// come together; which load cases act together by EN 1990; the plates of other steels; the
/// formulas of yield, throats, ranges, pins and their plates, rods, deflection, section class and
/// need of a shear buckling check.
///
/// It shares with the program: reading the case, the motion, the reactions, the loads on the beam
/// at an instant and their integration to cut forces; the section between two others; counting of
/// cycles, S-N lines and Miner's sum; how much of a wide flange shear lag leaves (beta); strengths
/// of a steel by thickness; the shear area of a section; and the torsion constant of a welded box.
///
/// It covers boxes, sharp rectangular tubes, round tubes, one in the other, and solid plates;
/// not: stresses given in the case, named points, welds around a profile, holes in solid plates,
/// the Newton chain, stiffened boxes whose webs may buckle in shear.
namespace oracle {

/// How densely it looks.
struct Density {
  int stations = 2000;  ///< along the beam, beside the cuts
  int around = 200;     ///< around a section
  int instants = 2000;  ///< of every situation
};

inline constexpr Density full{2000, 200, 2000};
/// For many cases in little time.
inline constexpr Density coarse{160, 48, 160};

/// The largest utilisation of a criterion and where it is.
struct Finding {
  double utilisation = 0.0;
  boxbeam::Station station;
  std::string place;  ///< of the section, or the neighbour's name
};

/// What it found.
struct Findings {
  std::map<boxbeam::Criterion, Finding> worst;
  std::string gate;          ///< why stresses mean nothing here; "" where nothing says so
  double most_cycles = 0.0;  ///< met in one repetition of a situation
  long evaluations = 0;      ///< of stresses at a place, over all instants

  double utilisation(boxbeam::Criterion criterion) const {
    const auto found = worst.find(criterion);
    return found == worst.end() ? 0.0 : found->second.utilisation;
  }
  /// Keeps what is worse than what is known.
  void note(boxbeam::Criterion criterion, double utilisation_there, const boxbeam::Station& station,
            const std::string& place);
  bool fails() const;
};

/// Whether the oracle covers a case.
bool covers(const boxbeam::Project& project);

Findings look_everywhere(const boxbeam::Project& project,
                         const std::deque<boxbeam::SituationRun>& runs, const Density& density,
                         const Combining& combining = {});

}  // namespace oracle
