#include "figure_kinds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "front_end_text.hpp"
#include "function_text.hpp"

namespace boxbeam::report {
namespace {

/// The check that decides the verdict; there is at least one in every case.
const Check& worst_check(const Source& source) { return source.verification.checks.front().check; }

std::string use_text(const Check& check) {
  return fmt::format("{} at {} is used {} and {}", to_text(check.criterion), place_of(check),
                     text::percent(check.utilisation()), check.passes() ? "passes" : "fails");
}

/// Where and when a bending moment is largest, whatever its sign; nullptr where none is looked at.
const CriticalInstant* largest_moment_of(const Source& source) {
  const CriticalInstant* largest = nullptr;
  for (const CriticalInstant& instant : source.verification.critical_instants) {
    if (!instant.force || !instant.force->bends()) continue;
    if (largest == nullptr || std::abs(instant.value) > std::abs(largest->value)) {
      largest = &instant;
    }
  }
  return largest;
}

std::string sketch_caption(const Source& source) {
  const Check& check = worst_check(source);
  return fmt::format(
      "The {} with the loads on the beam at the critical instant next to that of the governing "
      "check, t = {}{}.",
      front_end_text_of(source.project)->word(), text::seconds(check.time.value()),
      check.on_beam ? "; a circle marks its place" : "");
}

std::string use_caption(const Source& source) {
  return fmt::format("The largest utilisation at each station, by the criteria used most: {}.",
                     use_text(worst_check(source)));
}

std::string mechanism_caption(const Source& source) {
  const double begin = source.verification.pictures.postures.front().time.value();
  const std::string what =
      fmt::format("The {} {} and at the critical instants, with the loads on the beam",
                  front_end_text_of(source.project)->word(),
                  source.verification.pictures.elastic
                      ? "unloaded"
                      : "at t = " + (begin == 0.0 ? "0" : text::seconds(begin)));
  const BeamLoadRow* largest = nullptr;
  for (const PostureFigure& posture : source.verification.pictures.postures) {
    for (const BeamLoadRow& row : posture.loads) {
      if (largest == nullptr || row.world.norm() > largest->world.norm()) largest = &row;
    }
  }
  if (largest == nullptr) return what + ".";
  return fmt::format("{}: the largest is {} by {} at t = {}.", what,
                     text::kN(largest->world.norm()), largest->name,
                     text::seconds(largest->time.value()));
}

/// Where a driver goes, where no force is known that it needs.
std::string stroke_text(const DriverLine& driver) {
  const auto [low, high] = std::minmax_element(driver.position.begin(), driver.position.end());
  return driver.turns
             ? fmt::format("{} turns from {} to {}", driver.name, degrees(*low), degrees(*high))
             : fmt::format("{} goes from {} to {}", driver.name, text::mm(*low), text::mm(*high));
}

/// Whether forces move joints of a mechanism in space, and whether drivers move others.
struct MovedInSpace {
  bool by_forces = false, by_drivers = false;
};

MovedInSpace moved_in_space(const Project& project) {
  const auto* const space = std::get_if<spatial::Mechanism>(&project.mechanism);
  if (space == nullptr) return {};
  const auto& joints = space->joints;
  return {std::any_of(joints.begin(), joints.end(), spatial::is_forced),
          std::any_of(joints.begin(), joints.end(), spatial::is_driven)};
}

std::string motion_caption(const Source& source) {
  const auto& closure = source.verification.motions.front().closure;
  // Elsewhere forces are prescribed and the motion is the answer.
  const MovedInSpace space = moved_in_space(source.project);
  const bool driven = !source.verification.pictures.elastic &&
                      (!closure || closure->freedom.undriven == 0) &&
                      (!space.by_forces || space.by_drivers);
  const std::string what =
      driven && space.by_forces
          ? "Position, speed and acceleration that drivers prescribe and forces cause"
      : driven ? "Position, speed and acceleration that the drivers prescribe"
      : source.verification.pictures.elastic
          ? "Displacement, speed and acceleration with which the points of the prescribed loads "
            "answer them"
          : "Position, speed and acceleration that the prescribed forces cause";
  const DriverLine* hardest = nullptr;
  double largest = 0.0;
  for (const DriverLine& driver : source.verification.pictures.drivers) {
    for (const double force : driver.force) {
      if (hardest != nullptr && std::abs(force) <= largest) continue;
      hardest = &driver;
      largest = std::abs(force);
    }
  }
  if (hardest == nullptr) {
    return fmt::format("{}: {}.", what, stroke_text(source.verification.pictures.drivers.front()));
  }
  return fmt::format("{}, and {}: {} {} up to {}.", what,
                     driven ? "the force that this takes" : "these themselves", hardest->name,
                     driven ? "needs" : "has",
                     hardest->turns ? text::kNm(largest) : text::kN(largest));
}

std::string cut_force_caption(const Source& source) {
  const std::string what =
      "Cut forces along the beam at the critical instants, and between which "
      "values they stay";
  const CriticalInstant* moment = largest_moment_of(source);
  if (moment == nullptr) return what + ".";
  return fmt::format("{}: {} reaches {} at s = {} m, t = {}.", what, moment->quantity(),
                     text::kNm(moment->value), to_text(moment->station),
                     text::seconds(moment->time.value()));
}

std::string loads_caption(const Source& source) {
  const Station& station = source.verification.pictures.loads_over_time->station;
  return fmt::format(
      "Cut forces at s = {} m, where the governing check is, over the time that is "
      "looked at.",
      to_text(station));
}

std::string stress_caption(const Source& source) {
  const std::string what = "Normal stress over time at the places that are used most";
  const CheckResult* fatigue = source.verification.governing(Criterion::fatigue);
  if (fatigue == nullptr) return what + ".";
  return fmt::format("{}: at {} its range is {}{}.", what, place_of(fatigue->check),
                     text::MPa(fatigue->check.acting.value()),
                     in_brackets(fatigue->check.situation));
}

std::string section_caption(const Source& source) {
  const SectionFigure& section = *source.verification.pictures.section;
  const std::string what = fmt::format(
      "The section at s = {} m with the points that are checked, and the normal stress over its "
      "height",
      to_text(section.station));
  const auto governs =
      std::find_if(section.points.begin(), section.points.end(),
                   [](const SectionFigure::Point& point) { return point.governs; });
  if (governs == section.points.end()) return what + ".";
  return fmt::format("{}: {} governs with {} at t = {}, used {}.", what, governs->name,
                     text::MPa(governs->stress), text::seconds(section.time.value()),
                     text::percent(governs->utilisation));
}

std::string utilisation_caption(const Source& source) {
  return fmt::format("Utilisation along the beam: {}.", use_text(worst_check(source)));
}

std::string sn_caption(const Source& source) {
  const SnFigure& sn = *source.verification.pictures.sn;
  const std::string what = fmt::format(
      "S-N curve {} of {} and the cycles of the governing fatigue check", sn.name, sn.code);
  const CheckResult* fatigue = source.verification.governing(Criterion::fatigue);
  if (fatigue == nullptr || sn.working.empty()) return what + ".";
  const Check& check = fatigue->check;
  double factored = 0.0;
  for (const auto& [cycles, range] : sn.working) factored = std::max(factored, range);
  const FatigueDemand& demand = source.project.fatigue.demand;
  return fmt::format(
      "{}, {}: the largest range is {}, with partial factors, as drawn, {}; factor {}, required "
      "{}.",
      what, place_of(check), text::MPa(factored / (demand.gamma_Ff * demand.gamma_Mf)),
      text::MPa(factored), text::factor(check.safety_factor), text::factor(check.required));
}

std::string spectrum_caption(const Source& source) {
  const std::string what =
      "Stress ranges of the governing fatigue check, without partial factors, and how often they "
      "are exceeded in the wanted life";
  const CheckResult* fatigue = source.verification.governing(Criterion::fatigue);
  if (fatigue == nullptr || !fatigue->basis || fatigue->basis->spectrum.empty()) return what + ".";
  const std::vector<SpectrumRow>& rows = fatigue->basis->spectrum;
  const auto largest = std::max_element(
      rows.begin(), rows.end(),
      [](const SpectrumRow& a, const SpectrumRow& b) { return a.cycle.range < b.cycle.range; });
  const auto worst = std::max_element(
      rows.begin(), rows.end(),
      [](const SpectrumRow& a, const SpectrumRow& b) { return a.damage < b.damage; });
  const std::string reach =
      fmt::format("{}: the largest is {}", what, text::MPa(largest->cycle.range.value()));
  if (worst->damage == 0.0)
    return reach + "; with the loads as they are and partial factors none does damage.";
  return fmt::format(
      "{}; with the loads as they are and partial factors the damage is {}, of which the range of "
      "{}{} does {}.",
      reach, text::factor(fatigue->basis->damage), text::MPa(worst->cycle.range.value()),
      in_brackets(worst->situation), text::percent(worst->damage / fatigue->basis->damage));
}

std::string frequencies_text(const ElasticFigures& elastic) {
  std::string list;
  for (std::size_t i = 0; i < elastic.modes.size() && i < elastic.motion.frequencies.size(); ++i) {
    list += list.empty() ? "" : ", ";
    list += text::rounded(text::Quantity::frequency, elastic.motion.frequencies[i].frequency);
  }
  return list;
}

/// Of lines over time the joint with the largest force.
std::string largest_force(const JointLines& lines) {
  std::size_t worst = 0;
  double largest = 0.0;
  for (std::size_t j = 0; j < lines.names.size(); ++j) {
    for (const double force : lines.force[j]) {
      if (force <= largest) continue;
      largest = force;
      worst = j;
    }
  }
  return fmt::format("joint {} bears up to {}", lines.names[worst], text::kN(largest));
}

std::string modes_caption(const Source& source) {
  return fmt::format("The lowest natural modes, at {} Hz.",
                     frequencies_text(*source.verification.pictures.elastic));
}

std::string response_caption(const Source& source) {
  const bool damped = is_damped(flexible_of(source.project));
  return fmt::format(
      "Vibrating force of the joints over the frequency of the loads: it {} the natural "
      "frequencies; the loads have {} Hz.",
      damped ? "peaks, as high as the damping lets it, near" : "grows without bound at",
      text::rounded(text::Quantity::frequency,
                    source.verification.pictures.elastic->motion.frequency));
}

std::string joint_forces_caption(const Source& source) {
  return fmt::format("Forces of the joints over one period of the loads: {}.",
                     largest_force(source.verification.pictures.elastic->over_period));
}

std::string sudden_start_caption(const Source& source) {
  return fmt::format("Forces of the joints after the loads are switched on at once: {}.",
                     largest_force(source.verification.pictures.elastic->after_start));
}

bool has_posture(const Project&, const Verification& verification) {
  return verification.pictures.postures.size() > 1;
}

bool in_plane(const Project& project, const Verification&) { return !project.in_space; }

bool in_three_dimensions(const Project& project, const Verification&) { return project.in_space; }

bool is_driven(const Project&, const Verification& verification) {
  return !verification.pictures.cycles.empty() && !verification.pictures.drivers.empty();
}

bool over_time(const Project&, const Verification& verification) {
  return verification.pictures.loads_over_time.has_value();
}

bool is_checked_along(const Project&, const Verification& verification) {
  return std::any_of(verification.checks.begin(), verification.checks.end(),
                     [](const CheckResult& result) { return result.basis.has_value(); });
}

bool has_section(const Project&, const Verification& verification) {
  return verification.pictures.section.has_value();
}

/// The worst check of a criterion rests on cut forces.
bool is_computed(const Verification& verification, Criterion criterion) {
  const CheckResult* governing = verification.governing(criterion);
  return governing != nullptr && governing->basis;
}

bool has_history(const Project&, const Verification& verification) {
  return is_computed(verification, Criterion::fatigue) ||
         is_computed(verification, Criterion::yield);
}

bool has_curve(const Project&, const Verification& verification) {
  return verification.pictures.sn.has_value();
}

bool has_several_ranges(const Project&, const Verification& verification) {
  return is_computed(verification, Criterion::fatigue) &&
         verification.governing(Criterion::fatigue)->basis->spectrum.size() > 1;
}

bool is_elastic(const Project&, const Verification& verification) {
  return verification.pictures.elastic && !verification.pictures.elastic->modes.empty();
}

bool vibrates(const Project&, const Verification& verification) {
  return verification.pictures.elastic && !verification.pictures.elastic->over_period.at.empty();
}

bool shows_its_start(const Project&, const Verification& verification) {
  return verification.pictures.elastic && !verification.pictures.elastic->after_start.at.empty();
}

constexpr FigureKind kinds[] = {
    {"sketch", FigurePlace::opening, false, has_posture, sketch_caption, nullptr, plot::sketch},
    {"use", FigurePlace::opening, false, is_checked_along, use_caption, nullptr,
     plot::use_along_beam},
    {"mechanism", FigurePlace::mechanism, true, in_plane, mechanism_caption, nullptr,
     plot::mechanism},
    {"mechanism", FigurePlace::mechanism, true, in_three_dimensions, mechanism_caption, nullptr,
     plot::mechanism_in_space},
    {"motion", FigurePlace::motion, false, is_driven, motion_caption, plot::motion},
    {"cut-forces", FigurePlace::cut_forces, true, in_plane, cut_force_caption, plot::cut_forces},
    {"cut-forces", FigurePlace::cut_forces, true, in_three_dimensions, cut_force_caption,
     plot::cut_forces_in_space},
    {"loads", FigurePlace::cut_forces, false, over_time, loads_caption, plot::loads_over_time},
    {"utilisation", FigurePlace::checks, true, is_checked_along, utilisation_caption,
     plot::utilisation},
    {"section", FigurePlace::sections, false, has_section, section_caption, nullptr, plot::section},
    {"stress", FigurePlace::stresses, false, has_history, stress_caption, plot::stress},
    {"sn", FigurePlace::fatigue, true, has_curve, sn_caption, plot::sn},
    {"spectrum", FigurePlace::fatigue, false, has_several_ranges, spectrum_caption, plot::spectrum},
    {"modes", FigurePlace::vibration, false, is_elastic, modes_caption, nullptr, plot::modes},
    {"frequency-response", FigurePlace::vibration, false, vibrates, response_caption,
     plot::frequency_response},
    {"joint-forces", FigurePlace::vibration, false, vibrates, joint_forces_caption,
     plot::joint_forces},
    {"sudden-start", FigurePlace::vibration, false, shows_its_start, sudden_start_caption,
     plot::sudden_start},
};

template <class Wanted>
void add_where(const Source& source, std::vector<Block>& blocks, Wanted wanted) {
  for (const FigureKind& kind : kinds) {
    if (wanted(kind) && kind.shown(source.project, source.verification))
      blocks.emplace_back(Picture{kind.name, kind.caption(source)});
  }
}

}  // namespace

std::span<const FigureKind> figure_kinds() { return kinds; }

void add_pictures(const Source& source, FigurePlace place, std::vector<Block>& blocks) {
  add_where(source, blocks, [&](const FigureKind& kind) { return kind.place == place; });
}

void add_deciding_pictures(const Source& source, std::vector<Block>& blocks) {
  add_where(source, blocks, [](const FigureKind& kind) { return kind.decides; });
}

}  // namespace boxbeam::report
