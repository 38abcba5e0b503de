#include "comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/error.hpp"
#include "boxbeam/verification/model_choice.hpp"

namespace oracle {

using namespace boxbeam;

namespace {

/// Below this no utilisation matters; what is never stressed has no check.
constexpr double negligible = 1e-6;

/// Whether the oracle has no rule of its own.
bool is_unknown(Criterion criterion) {
  return criterion == Criterion::distortion || criterion == Criterion::distortion_fatigue ||
         criterion == Criterion::patch_fatigue;
}

/// Whether its rule is milder than the program's and is for some beams alone: what it finds is
/// missed where it is above, and what is reported may be far above it.
bool is_milder(Criterion criterion) { return criterion == Criterion::member; }

/// Of slender plates it knows that they need a check, not what that says.
bool judges_slender_plates(const Verification& verification) {
  return std::any_of(verification.checks.begin(), verification.checks.end(),
                     [](const CheckResult& result) {
                       const Criterion of = result.check.criterion;
                       return of == Criterion::effective_section ||
                              of == Criterion::shear_buckling || of == Criterion::reduced_stress;
                     });
}

/// Nor has it one of forces that come into webs and through their seams.
bool is_unknown(const CheckResult& result) {
  return is_unknown(result.check.criterion) || result.patch.has_value();
}

double reported(const Verification& verification, Criterion criterion) {
  double most = 0.0;
  for (const CheckResult& result : verification.checks) {
    if (result.check.criterion == criterion && !is_unknown(result))
      most = std::max(most, result.check.utilisation());
  }
  return most;
}

/// Why the verdict is another one than what the oracle found says.
std::string verdict_against(const Verification& verification, const Findings& findings) {
  const auto most = std::max_element(
      findings.worst.begin(), findings.worst.end(),
      [](const auto& a, const auto& b) { return a.second.utilisation < b.second.utilisation; });
  const double largest = most == findings.worst.end() ? 0.0 : most->second.utilisation;
  const bool fails = std::any_of(
      verification.checks.begin(), verification.checks.end(), [](const CheckResult& result) {
        return !is_unknown(result) && !is_milder(result.check.criterion) && !result.check.passes();
      });
  const bool by_member = most != findings.worst.end() && is_milder(most->first);
  if (!fails && !by_member && largest > 1.0 + allowed) {
    return fmt::format("{}, but {} is used to {:.4f}", to_text(verification.verdict),
                       to_text(most->first), largest);
  }
  // The oracle's grid may fall short of the worst place; of what it finds nowhere near it, nothing.
  if (fails && largest < 0.9) return fmt::format("fail, but nothing is used above {:.4f}", largest);
  if (verification.verdict == Verdict::pass && !findings.gate.empty() &&
      !judges_slender_plates(verification))
    return "pass, but " + findings.gate;
  return "";
}

}  // namespace

Comparison compare(const Verification& verification, const Findings& findings) {
  Comparison comparison;
  for (const Criterion criterion : criteria) {
    if (is_unknown(criterion)) continue;
    const double by_program = reported(verification, criterion);
    const auto found = findings.worst.find(criterion);
    const double by_oracle = findings.utilisation(criterion);
    if (by_oracle > negligible && by_oracle > (1.0 + allowed) * by_program)
      comparison.misses.push_back({criterion, by_program, found->second});
    if (by_program <= negligible || is_milder(criterion)) continue;
    const double above = 1.0 - by_oracle / by_program;
    if (above <= comparison.most_above) continue;
    comparison.most_above = above;
    comparison.above = to_text(criterion);
  }
  comparison.verdict = verdict_against(verification, findings);
  return comparison;
}

const char* to_text(Fault fault) {
  switch (fault) {
    case Fault::side_dropped: return "a side dropped";
    case Fault::detail_end_ignored: return "a detail's end ignored";
    case Fault::grid_of_24: return "a grid of 24";
  }
  return "";
}

Verification with_fault(const Verification& verification, const Project& project, Fault fault) {
  const auto at_end_of_detail = [&](Length s) {
    const auto ends = [s](const BeamDetail& detail) { return s == detail.from || s == detail.to; };
    const std::vector<Length> places = places_of(project.beam);
    return std::any_of(project.fatigue.details.begin(), project.fatigue.details.end(), ends) &&
           std::find(places.begin(), places.end(), s) == places.end();
  };
  const auto on_grid = [&](Length s) {
    return std::any_of(
        project.beam.segments.begin(), project.beam.segments.end(), [s](const Segment& segment) {
          const double steps = 24.0 * ((s - segment.start) / segment.length);
          return steps > -1e-6 && steps < 24.0 + 1e-6 && std::abs(steps - std::round(steps)) < 1e-6;
        });
  };
  Verification faulty = verification;
  std::erase_if(faulty.checks, [&](const CheckResult& result) {
    const Check& check = result.check;
    if (!check.on_beam || check.criterion == Criterion::deflection) return false;
    switch (fault) {
      case Fault::side_dropped: return check.station.side == Side::before;
      case Fault::detail_end_ignored: return at_end_of_detail(check.station.s);
      case Fault::grid_of_24: return !on_grid(check.station.s);
    }
    return false;
  });
  return faulty;
}

namespace {

/// Whether a faulty verification misses a criterion that the whole one does not.
bool misses_more(const Comparison& faulty, const Comparison& whole) {
  return std::any_of(faulty.misses.begin(), faulty.misses.end(), [&](const Miss& miss) {
    return std::none_of(whole.misses.begin(), whole.misses.end(),
                        [&](const Miss& other) { return other.criterion == miss.criterion; });
  });
}

}  // namespace

Outcome examine(const RandomCase& of, const std::string& folder, const Density& density) {
  Outcome outcome;
  const std::string path = of.write(folder);
  try {
    const Project project = read_project(path);
    if (!covers(project)) {
      outcome.kind = Outcome::Kind::not_covered;
      return outcome;
    }
    const ModelledRuns modelled = run_by_chosen_model(project);
    outcome.verification = judge(project, modelled.runs, modelled.model);
    outcome.findings = look_everywhere(project, modelled.runs, density, of.combining);
    outcome.comparison = compare(outcome.verification, outcome.findings);
    for (std::size_t i = 0; i < faults.size(); ++i) {
      outcome.shown[i] = misses_more(
          compare(with_fault(outcome.verification, project, faults[i]), outcome.findings),
          outcome.comparison);
    }
  } catch (const InputError& error) {
    outcome.kind = Outcome::Kind::refused;
    outcome.why = error.what();
  } catch (const AnalysisError& error) {
    outcome.kind = Outcome::Kind::not_analysed;
    outcome.why = error.what();
  }
  return outcome;
}

std::string to_text(const Miss& miss) {
  return fmt::format("{}: {:.5f} at s = {}, {}; reported {:.5f}{}", to_text(miss.criterion),
                     miss.found.utilisation, boxbeam::to_text(miss.found.station), miss.found.place,
                     miss.reported,
                     miss.reported > 0.0 ? fmt::format(" (+{:.2f} %)", 100.0 * miss.excess()) : "");
}

}  // namespace oracle
