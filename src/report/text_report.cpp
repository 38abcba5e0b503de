#include "boxbeam/report/text_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

#include "beam_text.hpp"
#include "boxbeam/report/format.hpp"
#include "boxbeam/report/remarks.hpp"
#include "calculation_sheet.hpp"
#include "chain_text.hpp"
#include "flexible_text.hpp"
#include "inputs_text.hpp"
#include "model_text.hpp"
#include "text_layout.hpp"
#include "version.hpp"

namespace boxbeam {
namespace {

using layout::heading;
using layout::paragraph;
using layout::Table;

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string where(const Check& check) {
  if (!check.on_beam) return check.point;
  return fmt::format("s = {} m, {}", to_text(check.station), check.point);
}

std::string governing_line(const Check& check) {
  return fmt::format("{:<8}{:<16} factor {:<5} required {:<5} utilisation {:<7} at {}, t = {}",
                     check.passes() ? "passes" : "FAILS", to_text(check.criterion),
                     text::significant(check.safety_factor, 3),
                     text::significant(check.required, 3), text::percent(check.utilisation()),
                     where(check), text::seconds(check.time.value()));
}

std::string verdict_lines(const Verification& verification) {
  std::string lines;
  std::vector<const CheckResult*> governing;
  for (const Criterion criterion : criteria) {
    if (const CheckResult* result = verification.governing(criterion)) governing.push_back(result);
  }
  std::stable_sort(governing.begin(), governing.end(),
                   [](const CheckResult* a, const CheckResult* b) {
                     return a->check.utilisation() > b->check.utilisation();
                   });
  for (const CheckResult* result : governing) lines += "  " + governing_line(result->check) + "\n";
  return lines;
}

/// How many checks, worst first, are above a utilisation, and at least `fewest`.
std::size_t checks_above(const Verification& verification, double utilisation, std::size_t fewest) {
  const auto below = std::find_if(
      verification.checks.begin(), verification.checks.end(),
      [&](const CheckResult& result) { return result.check.utilisation() < utilisation; });
  return std::max(static_cast<std::size_t>(below - verification.checks.begin()),
                  std::min(fewest, verification.checks.size()));
}

std::string checks_table(const Verification& verification, std::size_t most) {
  Table table({"use", "factor", "required", "criterion", "s [m]", "point", "when [s]", "acting",
               "resisting"});
  for (std::size_t i = 0; i < std::min(most, verification.checks.size()); ++i) {
    const Check& check = verification.checks[i].check;
    const bool range = check.criterion == Criterion::fatigue ||
                       check.criterion == Criterion::shear_fatigue ||
                       check.criterion == Criterion::stress_range;
    const char* kind = range                                            ? "range "
                       : check.criterion == Criterion::combined_fatigue ? "damage "
                                                                        : "";
    table.row({text::percent(check.utilisation()) + (check.passes() ? "  " : " !"),
               text::significant(check.safety_factor, 3), text::significant(check.required, 3),
               to_text(check.criterion), check.on_beam ? to_text(check.station) : "-", check.point,
               fmt::format("{:.4f}", check.time.value()),
               kind + text::amount(check.acting.value(), check.acting.unit()),
               text::amount(check.resisting.value(), check.resisting.unit())});
  }
  return table.text();
}

std::string case_section(const Project& project, const Verification& verification) {
  std::string out = heading("Case");
  out += fmt::format("  {}\n", project.title);
  out += fmt::format("  file          {}\n", project.path);
  for (const std::string& set : project.overrides) out += fmt::format("  --set         {}\n", set);
  out += fmt::format("  input sha256  {}\n", project.sha256);
  out += fmt::format("  program       boxbeam {}\n", version);
  out += fmt::format("  loads by      {}\n",
                     project.dynamics == Dynamics::rigorous
                         ? "reactions of the mechanism, distributed weight and inertia"
                         : "the published Newton chain");
  for (const MotionSummary& motion : verification.motions) {
    const std::string& name = project.situations[motion.situation].name;
    if (is_flexible(project) &&
        flexible_in(project, project.situations[motion.situation]).frequency == 0.0) {
      out += fmt::format("  period        none: the loads stand still{}\n",
                         name.empty() ? "" : " (" + name + ")");
      continue;
    }
    out += fmt::format("  period        {}, {} instants solved, extremes refined between them{}\n",
                       text::seconds(motion.period.value()), motion.instants,
                       name.empty() ? "" : " (" + name + ")");
  }
  return out + "\n";
}

/// How the joints close, for a mechanism of equations.
std::string closure_text(const planar::Mechanism& mechanism, const ClosureSummary& closure) {
  const planar::DegreesOfFreedom& freedom = closure.freedom;
  std::string out = fmt::format(
      "  degrees of freedom  {} by Gruebler, {} by the rank of the Jacobian; {} driver{}\n",
      freedom.gruebler, freedom.by_rank, freedom.drivers, freedom.drivers == 1 ? "" : "s");
  if (freedom.redundant > 0) {
    out += fmt::format("  redundant           {} equations, shared by {}\n", freedom.redundant,
                       fmt::join(planar::names_of_joints(mechanism, freedom.repeating), ", "));
  }
  if (freedom.undriven > 0) {
    out += fmt::format("  moved by forces     {} degree{} of freedom, integrated over time\n",
                       freedom.undriven, freedom.undriven == 1 ? "" : "s");
  } else {
    out += fmt::format("  digits left         {:.0f} of velocities, at worst (t = {})\n",
                       std::floor(closure.digits.left), text::seconds(closure.digits.time.value()));
  }
  for (std::size_t i = 0; i < closure.branch.size(); ++i) {
    out += fmt::format("  branch              loop {}: {}\n", mechanism.loops[i].name,
                       closure.branch[i] > 0 ? "+" : "-");
  }
  out += fmt::format("  joints closed to    {:.1e} of the mechanism's size at all instants\n\n",
                     closure.largest_residual);
  return out;
}

std::string mechanism_section(const Project& project, const Verification& verification) {
  std::string out = heading("Mechanism");
  if (in_space(project)) return out + chain_tables(spatial_of(project)) + "\n";
  if (verification.elastic) {
    return out + flexible_tables(flexible_of(project), verification.model.chosen) + "\n" +
           vibration_section(*verification.elastic, verification.model.chosen);
  }
  out += closure_text(planar_of(project), *verification.motions.front().closure);
  Table table({"body", "mass [kg]", "J about centre [kg m^2]"});
  for (const Body& body : planar_of(project).bodies) {
    table.row({body.name, text::significant(body.mass, 5), text::significant(body.inertia, 5)});
  }
  return out + table.text() + "\n";
}

std::string sheets_section(const Project& project, const Verification& verification) {
  std::string out = heading("Governing checks");
  for (const Criterion criterion : criteria) {
    if (const CheckResult* result = verification.governing(criterion)) {
      out += calculation_sheet(project, verification, *result) + "\n";
    }
  }
  return out;
}

std::string codes_section(const Verification& verification) {
  if (verification.codes.empty()) return "";
  std::string out = heading("The same beam under several codes");
  out +=
      "  Direct-stress fatigue: the same ranges, counts and partial factors on the curve of each "
      "code whose\n  strength at 2e6 cycles is nearest below that of the detail.\n\n";
  Table table({"code", "curve", "factor", "required", "use", "s [m]", "point", ""});
  for (const CodeResult& code : verification.codes) {
    if (!code.missing.empty()) {
      table.row({code.code, "-", "-", "-", "-", "-", "-", code.missing});
      continue;
    }
    table.row({code.code, code.curve, text::significant(code.safety_factor, 3),
               text::significant(code.required, 3),
               text::percent(code.required / code.safety_factor), to_text(code.station), code.point,
               code.unconfirmed ? "UNCONFIRMED" : ""});
  }
  return out + table.text() + "\n";
}

std::string chain_section(const Project& project, const Verification& verification) {
  if (!verification.chain) return "";
  const ChainComparison& chain = *verification.chain;
  const bool both = project.beam_body != planar::ground;
  std::string out = heading("Load models side by side");
  out += fmt::format(
      "  Published Newton chain (g_i = m_i a_i + g_(i-1), no lever arms){} at t = {}\n\n",
      both ? " beside the rigorous reactions" : "", text::seconds(chain.time.value()));
  Table table({"force on the beam, world axes", "Newton chain", both ? "rigorous" : ""});
  const auto row = [&](const char* name, double value, double rigorous) {
    table.row({name, text::kN(value), both ? text::kN(rigorous) : ""});
  };
  row("upper end, x", chain.chain_first.x(), chain.rigorous_first.x());
  row("upper end, y", chain.chain_first.y(), chain.rigorous_first.y());
  row("lower end, x", chain.chain_second.x(), chain.rigorous_second.x());
  row("lower end, y", chain.chain_second.y(), chain.rigorous_second.y());
  out += table.text();
  out += fmt::format("\n  mass the chain yields for body {}: {}\n", project.chain->last.name,
                     text::kilograms(chain.chain_mass.value()));
  out += paragraph(
      "The chain starts from the wanted equivalent mass times the blade's acceleration and hands "
      "the whole "
      "force on past the pivot. It ignores the lever ratio of the two arms, adds the beam's "
      "inertia to the "
      "forces at its ends instead of spreading it, and adds moments without force times arm; what "
      "is left "
      "over of the moments at the pivot, " +
      text::kNm(chain.moment_gap.value()) + ", is taken there as a couple.");
  return out + "\n";
}

std::string equivalent_mass_section(const Project& project, const Verification& verification) {
  if (!verification.equivalent_mass) return "";
  const planar::EquivalentMass& mass = *verification.equivalent_mass;
  const EquivalentMassDemand& demand = *project.equivalent_mass;
  const Body& body = planar_of(project).bodies[static_cast<std::size_t>(demand.adjust)];
  const std::string& joint = planar_of(project).joints[static_cast<std::size_t>(demand.joint)].name;
  std::string out = heading("Equivalent mass");
  out += paragraph("First harmonic of the force at " + joint +
                   " in phase with the acceleration there, divided by "
                   "the first harmonic of that acceleration: m_eq = <F_1, a_1>/<a_1, a_1>.");
  out += fmt::format("  with {} = {}: m_eq = {}\n", body.name, text::kilograms(body.mass),
                     text::kilograms(mass.given));
  out += fmt::format("  for m_eq = {}: {} = {} (m_eq grows by {} kg per kg)\n\n",
                     text::kilograms(demand.wanted.value()), body.name,
                     text::kilograms(mass.needed), text::significant(mass.per_mass, 4));
  return out;
}

}  // namespace

std::string summary(const Project& project, const Verification& verification) {
  constexpr std::size_t shown = 8;
  std::string out = fmt::format("{}  {}\n", upper(to_text(verification.verdict)), project.title);
  out += verdict_lines(verification);
  out += fmt::format("\nChecks, worst first ({} of {}):\n",
                     std::min(shown, verification.checks.size()), verification.checks.size());
  out += checks_table(verification, shown);
  out += "\nRemarks:\n";
  for (const std::string& remark : remarks_of(project, verification)) {
    if (!remark.starts_with("assumed: ")) out += layout::item(remark);
  }
  if (!project.assumptions.empty()) {
    out += layout::item(
        fmt::format("{} assumptions of the case stand in the report", project.assumptions.size()));
  }
  return out;
}

std::string text_report(const Project& project, const Verification& verification) {
  std::string out = fmt::format("boxbeam {}: {}\n\n", version, project.name);
  out += fmt::format("VERDICT: {}\n{}\n", upper(to_text(verification.verdict)),
                     verdict_lines(verification));
  out += case_section(project, verification);
  out += heading("Assumptions and remarks");
  for (const std::string& remark : remarks_of(project, verification)) out += layout::item(remark);
  out += "\n" + model_section(verification.model);
  out += heading("Inputs") + inputs_text(project) + "\n";
  out += mechanism_section(project, verification);
  out += loads_section(project, verification);
  out += cut_force_section(project, verification);
  out += section_section(project, verification);
  out += sheets_section(project, verification);
  out += heading("Checks, worst first");
  out +=
      "  use = required/factor; ! fails; a factor is the largest multiple of the whole load "
      "history that holds\n\n";
  constexpr double shown_above = 0.10;
  constexpr std::size_t fewest_shown = 24;
  const std::size_t shown = checks_above(verification, shown_above, fewest_shown);
  out += checks_table(verification, shown) + "\n";
  if (shown < verification.checks.size()) {
    out +=
        layout::paragraph(fmt::format(
            "{} more checks are less used than {}; all stand in "
            "results.json.",
            verification.checks.size() - shown,
            text::percent(shown == fewest_shown ? verification.checks[shown - 1].check.utilisation()
                                                : shown_above))) +
        "\n";
  }
  out += codes_section(verification);
  out += chain_section(project, verification);
  out += equivalent_mass_section(project, verification);
  return out;
}

}  // namespace boxbeam
