#include "boxbeam/verification/remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/plate_keys.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/verify.hpp"

namespace boxbeam {
namespace {

/// Up to so many instants times stations a case is verified ten times over in about a second. A
/// measure of the work, and no clock: the same case always gets the same answer.
constexpr double most_work = 1e5;

/// Thicker plates are looked for up to so many times the thickness.
constexpr double most_thickness = 4.0;

/// EN 1993-1-9:2005, figure 7.1 [MPa].
constexpr std::array categories{36, 40, 45, 50, 56, 63, 71, 80, 90, 100, 112, 125, 140, 160};

/// The largest utilisation of a case that passes; nothing where it does not.
using Outcome = std::optional<double>;

Outcome outcome_of(const Verification& verification) {
  if (verification.verdict != Verdict::pass) return std::nullopt;
  return verification.checks.front().check.utilisation();
}

/// A candidate that passes, by its number.
struct Passing {
  std::size_t candidate = 0;
  double utilisation = 0.0;
};

/// The first of candidates, from weak to strong, that passes, where the last one does.
std::optional<Passing> first_passing(std::size_t count,
                                     const std::function<Outcome(std::size_t)>& outcome) {
  if (count == 0) return std::nullopt;
  const Outcome strongest = outcome(count - 1);
  if (!strongest) return std::nullopt;
  Passing passing{count - 1, *strongest};
  for (std::size_t low = 0; low < passing.candidate;) {
    const std::size_t middle = low + (passing.candidate - low) / 2;
    if (const Outcome at = outcome(middle))
      passing = {middle, *at};
    else
      low = middle + 1;
  }
  return passing;
}

/// How many of the first candidates are possible, where none is behind one that is not.
std::size_t count_of_first(std::size_t count, const std::function<bool(std::size_t)>& possible) {
  std::size_t low = 0;
  while (low < count) {
    const std::size_t middle = low + (count - low) / 2;
    if (possible(middle))
      low = middle + 1;
    else
      count = middle;
  }
  return low;
}

bool is_by_fatigue(Criterion criterion) {
  return criterion == Criterion::fatigue || criterion == Criterion::combined_fatigue ||
         criterion == Criterion::shear_fatigue;
}

double work_of(const Verification& verification) {
  double instants = 0.0;
  for (const MotionSummary& motion : verification.motions)
    instants += static_cast<double>(motion.instants);
  return instants * static_cast<double>(verification.search.evaluations);
}

/// The same detail in a copy of the case; nullptr where it belongs to no stretch and no hole.
BeamDetail* same_in(Project& copy, const Project& project, const BeamDetail& detail) {
  const auto same = [&](const BeamDetail& other) {
    return &other == &detail ||
           (other.detail.name == detail.detail.name && other.from == detail.from &&
            other.to == detail.to && other.on == detail.on);
  };
  if (same(project.fatigue.beam)) return &copy.fatigue.beam;
  for (std::size_t i = 0; i < project.fatigue.details.size(); ++i) {
    if (same(project.fatigue.details[i])) return &copy.fatigue.details[i];
  }
  for (std::size_t i = 0; i < project.holes.size(); ++i) {
    if (project.holes[i].detail && same(*project.holes[i].detail)) return &*copy.holes[i].detail;
  }
  return nullptr;
}

/// As a case has it that writes category = so many.
void give_category(Detail& detail, int category) {
  detail.row.clear();
  detail.curve = en_1993_1_9_direct(category);
  detail.size_effect = SizeEffect::none;
  detail.size_factor = 1.0;
  detail.unconfirmed = false;
  detail.candidates.clear();
  detail.deciding.clear();
  detail.raises.clear();
  detail.in_plates.reset();
}

/// Runs whose situations are those of a copy of their case for a while.
class LentRuns {
 public:
  LentRuns(std::deque<SituationRun>& runs, const Project& owner, const Project& copy)
      : runs_(runs) {
    for (SituationRun& run : runs) {
      owned_.push_back(run.situation);
      run.situation = &copy.situations[index_of(owner, *run.situation)];
    }
  }
  LentRuns(const LentRuns&) = delete;
  LentRuns& operator=(const LentRuns&) = delete;
  ~LentRuns() {
    for (std::size_t i = 0; i < owned_.size(); ++i) runs_[i].situation = owned_[i];
  }

 private:
  std::deque<SituationRun>& runs_;
  std::vector<const Situation*> owned_;
};

/// The search for one case.
class Search {
 public:
  Search(const Project& project, std::deque<SituationRun>& runs, const Verification& verification)
      : project_(project),
        runs_(runs),
        verification_(verification),
        governing_(verification.checks.front()) {}

  Remedies remedies() {
    const Criterion criterion = governing_.check.criterion;
    const bool by_strength = criterion == Criterion::yield || criterion == Criterion::stress_range;
    const bool by_throat = criterion == Criterion::weld;
    const bool by_buckling = governing_.plates || governing_.path || governing_.patch;
    const bool by_distortion = governing_.distortion.has_value();
    if (!is_by_fatigue(criterion) && !by_strength && !by_throat && !by_buckling && !by_distortion)
      return std::move(remedies_);
    if (!governing_.basis && !by_buckling && !by_distortion) {
      remedies_.not_searched.emplace_back("what would pass (the stresses are given)");
      return std::move(remedies_);
    }
    if (work_of(verification_) > most_work) {
      remedies_.not_searched.emplace_back("what would pass (it takes too long)");
      return std::move(remedies_);
    }
    if (by_buckling) {
      look_at_buckling();
      return std::move(remedies_);
    }
    if (by_distortion) {
      look_at_diaphragms();
      const Profile& profile =
          project_.beam.segments[segment_at(project_.beam, governing_.check.station)].from.outer;
      if (std::holds_alternative<Box>(profile)) {
        look_at_plates(PlateGroup::flanges);
        look_at_plates(PlateGroup::webs);
      } else {
        look_at_plates(PlateGroup::walls);
      }
      return std::move(remedies_);
    }
    const StressPoint& point = governing_.basis->point;
    const bool of_line = is_in_weld(point);
    if (of_line || (point.on_throat && is_filleted(point))) {
      of_line ? look_at_weld() : look_at_seams();
      return std::move(remedies_);
    }
    if (by_throat) return std::move(remedies_);
    if (by_strength)
      look_at_steels();
    else if (criterion != Criterion::shear_fatigue)
      look_at_categories();
    const std::size_t segment = segment_at(project_.beam, governing_.check.station);
    const Profile& profile = project_.beam.segments[segment].from.outer;
    look_at_plates(!std::holds_alternative<Box>(profile) ? PlateGroup::walls
                   : point.part == SectionPart::web      ? PlateGroup::webs
                                                         : PlateGroup::flanges);
    return std::move(remedies_);
  }

 private:
  bool is_in_weld(const StressPoint& point) const {
    return std::any_of(project_.welds.begin(), project_.welds.end(),
                       [&](const WeldInput& weld) { return point.detail == &weld.root; });
  }

  /// Whether the seam of a point has a throat of its own, and is not as thick as its web.
  static bool is_filleted(const StressPoint& point) {
    return std::get<Box>(point.section.outer).seam_throat.value() > 0.0;
  }

  /// Up to the next half millimetre; round-off does not count.
  static Length in_half_millimetres(Length throat) {
    constexpr double half = 0.5e-3;
    return si<Length>(half * std::ceil(throat.value() / half * (1.0 - 1e-9)));
  }

  void note_throat(const std::string& name, Length throat, const Outcome& outcome) {
    if (outcome)
      remedies_.found.push_back({Remedy::What::throat,
                                 fmt::format("{:.6g} mm throat of {}", throat.value() * 1e3, name),
                                 throat.value(), *outcome});
    else
      remedies_.in_vain.push_back("a thicker throat of " + name);
  }

  void look_at_weld() {
    Project copy = project_;
    for (std::size_t i = 0; i < project_.welds.size(); ++i) {
      if (governing_.basis->point.detail != &project_.welds[i].root) continue;
      const std::string name = "weld " + project_.welds[i].name;
      if (!governing_.sufficient_throat) {
        remedies_.in_vain.push_back("a thicker throat of " + name);
        return;
      }
      const Length throat = in_half_millimetres(*governing_.sufficient_throat);
      copy.welds[i].throat = throat;
      note_throat(name, throat, judged(copy));
      return;
    }
  }

  /// All seams of the beam that are thinner than the one that is needed most.
  void look_at_seams() {
    Length needed{};
    for (const CheckResult& result : verification_.checks) {
      if (result.basis && result.basis->point.on_throat && result.sufficient_throat)
        needed = std::max(needed, *result.sufficient_throat);
    }
    const Length throat = in_half_millimetres(needed);
    Project copy = project_;
    for (Segment& segment : copy.beam.segments) {
      for (Section* section : {&segment.from, &segment.to}) {
        auto* box = std::get_if<Box>(&section->outer);
        if (box != nullptr && box->seam_throat.value() > 0.0)
          box->seam_throat = std::max(box->seam_throat, throat);
      }
    }
    note_throat("the seams", throat, judged(copy));
  }

  /// The copy is judged under the loads that are there, whose situations it takes over.
  Outcome judged(const Project& copy) {
    const LentRuns lent(runs_, project_, copy);
    return outcome_of(judge(copy, runs_, verification_.model));
  }

  void look_at_categories() {
    const StressPoint& point = governing_.basis->point;
    if (point.detail == nullptr || project_.fatigue.published_step) return;
    const SnCurve curve = curve_of(point.detail->detail);
    const SnCurve standard = en_1993_1_9_direct(100.0);
    Project copy = project_;
    BeamDetail* const detail = same_in(copy, project_, *point.detail);
    if (detail == nullptr || curve.code != standard.code) return;
    // Direct stress alone is used in inverse proportion to the strength: less need not be tried.
    const double now = curve.reference.value();
    const double least = governing_.check.criterion == Criterion::fatigue
                             ? now * governing_.check.utilisation()
                             : now;
    std::vector<int> better;
    for (const int category : categories) {
      const double reference = category * 1e6;
      if (reference > now * (1.0 + 1e-9) && reference > least * (1.0 - 1e-9))
        better.push_back(category);
    }
    const auto passing = first_passing(better.size(), [&](std::size_t i) {
      give_category(detail->detail, better[i]);
      return judged(copy);
    });
    if (passing) {
      const int category = better[passing->candidate];
      remedies_.found.push_back({Remedy::What::category, fmt::format("category {}", category),
                                 static_cast<double>(category), passing->utilisation});
    } else if (categories.back() * 1e6 > curve.reference.value()) {
      remedies_.in_vain.push_back(fmt::format("a detail up to category {}", categories.back()));
    }
  }

  /// Whether a steel is for all plates of the beam.
  bool is_for_all_plates(const Material& steel) const {
    const std::vector<Segment>& segments = project_.beam.segments;
    return std::all_of(segments.begin(), segments.end(), [&](const Segment& segment) {
      // A solid is as thick as its smaller side, at most its height.
      std::vector<Length> plates = thicknesses_of(segment.from);
      const std::vector<Length> more = thicknesses_of(segment.to);
      plates.insert(plates.end(), more.begin(), more.end());
      plates.push_back(governing_.basis->point.plate);
      return std::all_of(plates.begin(), plates.end(), [&](const Length& plate) {
        return yield_strength_of(steel, plate).has_value();
      });
    });
  }

  void look_at_steels() {
    const StressPoint& point = governing_.basis->point;
    const Material& now = *point.first_to_yield.material;
    if (!find_steel(now.name)) return;
    const auto strength = [&](const Material& steel) {
      return yield_strength_of(steel, point.first_to_yield.thickness)->value();
    };
    std::vector<Material> stronger;
    for (const std::string& name : steel_names()) {
      Material steel = *find_steel(name);
      if (is_for_all_plates(steel) && strength(steel) > point.yield_strength.value())
        stronger.push_back(std::move(steel));
    }
    std::stable_sort(stronger.begin(), stronger.end(), [&](const Material& a, const Material& b) {
      return strength(a) < strength(b);
    });
    Project copy = project_;
    const auto passing = first_passing(stronger.size(), [&](std::size_t i) {
      // Of several materials the one that governs.
      if (project_.material.name == now.name) copy.material = stronger[i];
      for (std::size_t k = 0; k < project_.part_materials.size(); ++k) {
        if (project_.part_materials[k].material.name == now.name)
          copy.part_materials[k].material = stronger[i];
      }
      return judged(copy);
    });
    if (passing) {
      const Material& steel = stronger[passing->candidate];
      const std::string in_place =
          project_.part_materials.empty() ? "" : " in place of " + now.name;
      remedies_.found.push_back(
          {Remedy::What::steel, steel.name + in_place, strength(steel), passing->utilisation});
    } else if (!stronger.empty()) {
      remedies_.in_vain.push_back("a steel up to " + stronger.back().name);
    }
  }

  /// The case with other thicknesses, read anew, for its masses and loads change with them; nothing
  /// where there is no place for such plates.
  std::optional<Project> changed_by(const std::vector<std::string>& set) const {
    std::vector<std::string> overrides = project_.overrides;
    overrides.insert(overrides.end(), set.begin(), set.end());
    try {
      Project changed = std::move(parse_beams(project_.path, project_.text, overrides,
                                              project_.dynamics)[project_.beam_index]);
      changed.model.demand = project_.model.demand;
      changed.model.tolerance = project_.model.tolerance;
      return changed;
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

  /// A case that cannot be analysed does not pass.
  Outcome verified_with(const std::vector<std::string>& set) const {
    const std::optional<Project> changed = changed_by(set);
    if (!changed) return std::nullopt;
    try {
      return outcome_of(verify(*changed));
    } catch (const AnalysisError&) {
      return std::nullopt;
    }
  }

  void look_at_buckling() {
    const std::size_t segment = segment_at(project_.beam, governing_.check.station);
    const Profile& profile = project_.beam.segments[segment].from.outer;
    if (!std::holds_alternative<Box>(profile)) {
      look_at_plates(PlateGroup::walls);
    } else if (governing_.check.criterion == Criterion::effective_section) {
      look_at_plates(PlateGroup::flanges);
      look_at_plates(PlateGroup::webs);
    } else {
      const bool flange = governing_.plates && governing_.plates->plate != nullptr &&
                          is_flange(governing_.plates->plate->plate);
      look_at_plates(flange ? PlateGroup::flanges : PlateGroup::webs);
    }
    // What is pressed along the beam does not ask how long its panels are.
    if (governing_.check.criterion != Criterion::effective_section) look_at_diaphragms();
  }

  static bool stands_at(const TaperedBeam& beam, Length s, Length near) {
    return std::any_of(beam.diaphragms.begin(), beam.diaphragms.end(),
                       [&](const Diaphragm& of) { return abs(of.s - s) <= near; });
  }

  /// Where the force comes in that governs, or the torque that does most of it.
  std::optional<Length> place_that_governs() const {
    if (governing_.patch) return governing_.check.station.s;
    if (governing_.distortion) return governing_.distortion->introduced;
    return std::nullopt;
  }

  /// From few to many; no closer than half the depth of the beam.
  void look_at_diaphragms() {
    const TaperedBeam& beam = project_.beam;
    const std::size_t segment = segment_at(beam, governing_.check.station);
    const Profile& profile = beam.segments[segment].from.outer;
    const auto most = static_cast<std::size_t>(2.0 * (beam.length() / height_of(profile)).value());
    Length thickness;
    for (const Diaphragm& of : beam.diaphragms) thickness = std::max(thickness, of.thickness);
    if (thickness == Length{}) {
      for (const Length& plate : thicknesses_of(beam.segments[segment].from))
        thickness = std::max(thickness, plate);
    }
    Project copy = project_;
    const auto with_panels = [&](std::size_t panels) {
      copy.beam.diaphragms = beam.diaphragms;
      const Length near = 1e-6 * beam.length();
      for (std::size_t i = 0; i <= panels; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(panels);
        const Length s = place_near(places_of(beam), share * beam.length());
        if (!stands_at(beam, s, near)) copy.beam.diaphragms.push_back({s, thickness, {}});
      }
      // One takes the force, or the torque, that governs.
      if (const auto s = place_that_governs(); s && !stands_at(copy.beam, *s, near))
        copy.beam.diaphragms.push_back({*s, thickness, {}});
      std::sort(copy.beam.diaphragms.begin(), copy.beam.diaphragms.end(),
                [](const Diaphragm& a, const Diaphragm& b) { return a.s < b.s; });
      return judged(copy);
    };
    const auto passing = first_passing(most, [&](std::size_t i) { return with_panels(i + 1); });
    if (!passing) {
      remedies_.in_vain.emplace_back("diaphragms at half the depth of the beam");
      return;
    }
    const Length apart = beam.length() / static_cast<double>(passing->candidate + 1);
    std::string name =
        fmt::format("{:.6g} mm diaphragms every {:.4g} m", 1e3 * thickness.value(), apart.value());
    constexpr double near = 1e-6;
    if (const auto at = place_that_governs()) {
      const double panels = (*at / apart).value();
      if (std::abs(panels - std::round(panels)) > near)
        name += fmt::format(" and at {:.4g} m", at->value());
    }
    remedies_.found.push_back(
        {Remedy::What::diaphragms, std::move(name), apart.value(), passing->utilisation});
  }

  void look_at_plates(PlateGroup group) {
    const std::size_t segment = segment_at(project_.beam, governing_.check.station);
    const bool box = group != PlateGroup::walls;
    const bool flanges = group == PlateGroup::flanges;
    const std::string word = flanges ? "flanges" : box ? "webs" : "walls";
    const bool bends = verification_.model.bends_rigid_motion &&
                       verification_.model.chosen.level != ModelLevel::rigid;
    if (bends || std::holds_alternative<flexible::Mechanism>(project_.mechanism)) {
      remedies_.not_searched.push_back(fmt::format("thicker {} (the model is elastic)", word));
      return;
    }
    const std::vector<PlateKey> keys = plate_keys_of(project_, segment, group);
    if (keys.empty()) {
      remedies_.not_searched.push_back(
          fmt::format("thicker {} (no key of the case says how thick they are)", word));
      return;
    }
    const auto thickest =
        std::max_element(keys.begin(), keys.end(), [](const PlateKey& a, const PlateKey& b) {
          return a.thickness < b.thickness;
        })->thickness;
    // Candidates: the thickest plate in whole millimetres, the others by the same factor.
    constexpr double mm = 1e-3;
    const double now = thickest.value() / mm;
    const int first = static_cast<int>(std::floor(now * (1.0 + 1e-9))) + 1;
    const int most = static_cast<int>(std::floor(most_thickness * now));
    const auto thicknesses_at = [&](std::size_t i) {
      const double factor = (first + static_cast<double>(i)) / now;
      std::vector<int> thicknesses;
      for (const PlateKey& key : keys)
        thicknesses.push_back(
            static_cast<int>(std::ceil(factor * key.thickness.value() / mm - 1e-6)));
      return thicknesses;
    };
    const auto set_at = [&](std::size_t i) {
      const std::vector<int> thicknesses = thicknesses_at(i);
      std::vector<std::string> set;
      for (std::size_t k = 0; k < keys.size(); ++k)
        set.push_back(fmt::format("{}={} mm", keys[k].key, thicknesses[k]));
      return set;
    };
    const std::size_t wanted = static_cast<std::size_t>(std::max(0, most - first + 1));
    const std::size_t count =
        count_of_first(wanted, [&](std::size_t i) { return changed_by(set_at(i)).has_value(); });
    const auto passing =
        least_thickness(count, [&](std::size_t i) { return verified_with(set_at(i)); });
    if (!passing) {
      const int last = first + static_cast<int>(count) - 1;
      remedies_.in_vain.push_back(
          count == 0 ? fmt::format("thicker {}, for which there is no room,", word)
          : count < wanted
              ? fmt::format("{} up to {} mm, the most for which there is room,", word, last)
              : fmt::format("{} up to {} mm", word, last));
      return;
    }
    std::vector<int> thicknesses = thicknesses_at(passing->candidate);
    std::sort(thicknesses.begin(), thicknesses.end());
    thicknesses.erase(std::unique(thicknesses.begin(), thicknesses.end()), thicknesses.end());
    remedies_.found.push_back({flanges ? Remedy::What::flanges
                               : box   ? Remedy::What::webs
                                       : Remedy::What::walls,
                               fmt::format("{} mm {}", fmt::join(thicknesses, " and "), word),
                               thicknesses.back() * mm, passing->utilisation,
                               set_at(passing->candidate)});
  }

  /// Upwards in growing steps until one passes, then between it and the one before: a plate that is
  /// far too thick need not pass, for its weight.
  static std::optional<Passing> least_thickness(
      std::size_t count, const std::function<Outcome(std::size_t)>& outcome) {
    constexpr double growth = 1.8;
    std::size_t failing = 0;  // candidates below it do not pass
    for (double step = 2.0; failing < count; step *= growth) {
      const std::size_t upper = std::min(count, failing + static_cast<std::size_t>(step));
      const auto passing =
          first_passing(upper - failing, [&](std::size_t i) { return outcome(failing + i); });
      if (passing) return Passing{failing + passing->candidate, passing->utilisation};
      failing = upper;
    }
    return std::nullopt;
  }

  const Project& project_;
  std::deque<SituationRun>& runs_;
  const Verification& verification_;
  const CheckResult& governing_;
  Remedies remedies_;
};

}  // namespace

const char* to_text(Remedy::What what) {
  switch (what) {
    case Remedy::What::category: return "detail category";
    case Remedy::What::flanges: return "flange thickness";
    case Remedy::What::webs: return "web thickness";
    case Remedy::What::walls: return "wall thickness";
    case Remedy::What::steel: return "steel";
    case Remedy::What::throat: return "weld throat";
    case Remedy::What::diaphragms: return "diaphragm spacing";
  }
  return "";
}

const char* unit_of(Remedy::What what) {
  switch (what) {
    case Remedy::What::category: return "1";
    case Remedy::What::flanges:
    case Remedy::What::webs:
    case Remedy::What::walls:
    case Remedy::What::throat:
    case Remedy::What::diaphragms: return "m";
    case Remedy::What::steel: return "Pa";
  }
  return "";
}

Remedies remedies_of(const Project& project, std::deque<SituationRun>& runs,
                     const Verification& verification) {
  if (verification.verdict != Verdict::fail) return {};
  return Search(project, runs, verification).remedies();
}

}  // namespace boxbeam
