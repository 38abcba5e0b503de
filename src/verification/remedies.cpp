#include "boxbeam/verification/remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/verification/plate_checks.hpp"
#include "remedy_search.hpp"

namespace boxbeam {
namespace {

/// Up to so many instants times stations a case is verified ten times over in about a second. A
/// measure of the work, and no clock: the same case always gets the same answer.
constexpr double most_work = 1e5;

/// EN 1993-1-9:2005, figure 7.1 [MPa].
constexpr std::array categories{36, 40, 45, 50, 56, 63, 71, 80, 90, 100, 112, 125, 140, 160};

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

/// What a case says of the welds of attachments it says of all of a kind.
bool are_of_a_kind(const AttachmentWeld& a, const AttachmentWeld& b) {
  const auto is_end = [](const AttachmentWeld& of) { return of.detail.from == of.detail.to; };
  return a.flat.has_value() == b.flat.has_value() && is_end(a) == is_end(b);
}

/// The same detail in a copy of the case; none where it belongs to no stretch and no hole.
std::vector<BeamDetail*> same_in(Project& copy, const Project& project, const BeamDetail& detail) {
  const auto same = [&](const BeamDetail& other) {
    return &other == &detail ||
           (other.detail.name == detail.detail.name && other.from == detail.from &&
            other.to == detail.to && other.on == detail.on);
  };
  if (same(project.fatigue.beam)) return {&copy.fatigue.beam};
  for (std::size_t i = 0; i < project.fatigue.details.size(); ++i) {
    if (same(project.fatigue.details[i])) return {&copy.fatigue.details[i]};
  }
  for (std::size_t i = 0; i < project.holes.size(); ++i) {
    if (project.holes[i].detail && same(*project.holes[i].detail)) return {&*copy.holes[i].detail};
  }
  for (const AttachmentWeld& weld : project.fatigue.attachments) {
    if (!same(weld.detail)) continue;
    std::vector<BeamDetail*> all;
    for (AttachmentWeld& other : copy.fatigue.attachments)
      if (are_of_a_kind(weld, other)) all.push_back(&other.detail);
    return all;
  }
  return {};
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

/// What a thicker weld, a better detail or a stronger steel does, and what else is looked at.
class Search {
 public:
  Search(const Project& project, std::deque<SituationRun>& runs, const Verification& verification)
      : search_{project, runs, verification, verification.checks.front()} {}

  Remedies remedies() {
    const Check& check = governing_.check;
    const bool by_strength =
        check.criterion == Criterion::yield || check.criterion == Criterion::stress_range;
    const bool by_plates =
        governing_.plates || governing_.path || governing_.patch || governing_.distortion;
    const bool by_stress =
        by_strength || is_by_fatigue(check.criterion) || check.criterion == Criterion::weld;
    if (!by_plates && !by_stress) return std::move(remedies_);
    if (!governing_.basis && !by_plates) {
      remedies_.not_searched.emplace_back("what would pass (the stresses are given)");
    } else if (work_of(search_.verification) > most_work) {
      remedies_.not_searched.emplace_back("what would pass (it takes too long)");
    } else if (check.criterion == Criterion::weld && governing_.patch) {
      look_at_seams();
    } else if (by_plates) {
      look_at_what_gives_way();
    } else {
      look_at_stressed_point(by_strength);
    }
    return std::move(remedies_);
  }

 private:
  /// Plates that buckle, webs under forces, boxes that are distorted.
  void look_at_what_gives_way() {
    const bool box = std::holds_alternative<Box>(search_.profile());
    const bool in_bending = governing_.check.criterion == Criterion::effective_section;
    if (governing_.distortion) look_at_diaphragms(search_);
    if (!box) {
      look_at_plates(search_, PlateGroup::walls);
    } else if (governing_.distortion || in_bending) {
      look_at_plates(search_, PlateGroup::flanges);
      look_at_plates(search_, PlateGroup::webs);
    } else {
      const bool flange = governing_.plates && governing_.plates->plate != nullptr &&
                          is_flange(governing_.plates->plate->plate);
      look_at_plates(search_, flange ? PlateGroup::flanges : PlateGroup::webs);
    }
    if (box && governing_.plates) look_at_stiffeners(search_);
    const bool is_borne =
        governing_.patch && std::holds_alternative<BearingStiffener>(governing_.patch->bears);
    // What is pressed along the beam asks how long its panels are where flats hold it.
    if (is_borne)
      look_at_diaphragm(search_);
    else if (!governing_.distortion && (!in_bending || has_flats()))
      look_at_diaphragms(search_);
  }

  bool has_flats() const {
    if (!governing_.plates) return false;
    const auto& walls = governing_.plates->plates->box.box().walls;
    return std::any_of(walls.begin(), walls.end(),
                       [](const BoxWall& wall) { return !wall.stiffeners.empty(); });
  }

  void look_at_stressed_point(bool by_strength) {
    const StressPoint& point = governing_.basis->point;
    const Criterion criterion = governing_.check.criterion;
    const bool of_line = is_in_weld(point);
    if (of_line || (point.on_throat && is_filleted(point)))
      return of_line ? look_at_weld() : look_at_seams();
    if (criterion == Criterion::weld) return;
    if (by_strength)
      look_at_steels();
    else if (criterion != Criterion::shear_fatigue)
      look_at_categories();
    look_at_plates(search_, !std::holds_alternative<Box>(search_.profile()) ? PlateGroup::walls
                            : point.part == SectionPart::web                ? PlateGroup::webs
                                                                            : PlateGroup::flanges);
  }

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
      note_throat(name, throat, search_.judged(copy));
      return;
    }
  }

  static bool is_of_diaphragm(const CheckResult& result) {
    return result.patch && std::holds_alternative<StiffenerWeld>(result.patch->bears);
  }

  /// All seams of the beam, or welds of its diaphragms, that are thinner than the one that is
  /// needed most.
  void look_at_seams() {
    const bool of_diaphragms = is_of_diaphragm(governing_);
    Length needed{};
    for (const CheckResult& result : search_.verification.checks) {
      const bool of_weld = result.patch || (result.basis && result.basis->point.on_throat);
      if (of_weld && result.sufficient_throat && is_of_diaphragm(result) == of_diaphragms)
        needed = std::max(needed, *result.sufficient_throat);
    }
    const Length throat = in_half_millimetres(needed);
    Project copy = project_;
    if (of_diaphragms) {
      for (Diaphragm& of : copy.beam.diaphragms) {
        if (of.throat > Length{}) of.throat = std::max(of.throat, throat);
      }
      note_throat("the diaphragms' welds", throat, search_.judged(copy));
      return;
    }
    for (Segment& segment : copy.beam.segments) {
      for (Section* section : {&segment.from, &segment.to}) {
        auto* box = std::get_if<Box>(&section->outer);
        if (box != nullptr && box->seam_throat.value() > 0.0)
          box->seam_throat = std::max(box->seam_throat, throat);
      }
    }
    note_throat("the seams", throat, search_.judged(copy));
  }

  void look_at_categories() {
    const StressPoint& point = governing_.basis->point;
    if (point.detail == nullptr || project_.fatigue.published_step) return;
    const SnCurve curve = curve_of(point.detail->detail);
    const SnCurve standard = en_1993_1_9_direct(100.0);
    Project copy = project_;
    const std::vector<BeamDetail*> details = same_in(copy, project_, *point.detail);
    if (details.empty() || curve.code != standard.code) return;
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
      for (BeamDetail* const detail : details) give_category(detail->detail, better[i]);
      return search_.judged(copy);
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
      return search_.judged(copy);
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

  RemedySearch search_;
  const Project& project_ = search_.project;
  const CheckResult& governing_ = search_.governing;
  Remedies& remedies_ = search_.remedies;
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
    case Remedy::What::stiffeners: return "stiffeners";
    case Remedy::What::diaphragms: return "diaphragm spacing";
    case Remedy::What::diaphragm: return "diaphragm thickness";
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
    case Remedy::What::stiffeners:
    case Remedy::What::diaphragms:
    case Remedy::What::diaphragm: return "m";
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
