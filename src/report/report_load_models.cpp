#include <fmt/format.h>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

void add_chain(const Project& project, const ChainComparison& chain, std::vector<Block>& blocks) {
  const bool both = project.beam_body != planar::ground;
  blocks.emplace_back(Subheading{"Load models side by side"});
  Table table = table_of(
      fmt::format("Published Newton chain (g_i = m_i a_i + g_(i-1), no lever arms){} at t = {}",
                  both ? " beside the rigorous reactions" : "", text::seconds(chain.time.value())),
      {"force on the beam, world axes", "Newton chain [kN]"});
  if (both) table.header.emplace_back("rigorous [kN]");
  const auto row = [&](const char* name, double value, double rigorous) {
    std::vector<Cell> cells = row_of(name, cell(Quantity::force, value));
    if (both) cells.push_back(cell(Quantity::force, rigorous));
    add_row(table, std::move(cells));
  };
  row("upper end, x", chain.chain_first.x(), chain.rigorous_first.x());
  row("upper end, y", chain.chain_first.y(), chain.rigorous_first.y());
  row("lower end, x", chain.chain_second.x(), chain.rigorous_second.x());
  row("lower end, y", chain.chain_second.y(), chain.rigorous_second.y());
  blocks.emplace_back(std::move(table));
  blocks.emplace_back(Paragraph{fmt::format(
      "The chain yields {} for body {}. It starts from the wanted equivalent mass times the "
      "blade's acceleration and hands the whole force on past the pivot. It ignores the lever "
      "ratio of the two arms, adds the beam's inertia to the forces at its ends instead of "
      "spreading it, and adds moments without force times arm; what is left over of the moments "
      "at the pivot, {}, is taken there as a couple.",
      text::kilograms(chain.chain_mass.value()), project.chain->last.name,
      text::kNm(chain.moment_gap.value()))});
}

void add_equivalent_mass(const Project& project, const planar::EquivalentMass& mass,
                         std::vector<Block>& blocks) {
  const EquivalentMassDemand& demand = *project.equivalent_mass;
  const Body& body = planar_of(project).bodies[static_cast<std::size_t>(demand.adjust)];
  const std::string& joint = planar_of(project).joints[static_cast<std::size_t>(demand.joint)].name;
  blocks.emplace_back(Subheading{"Equivalent mass"});
  blocks.emplace_back(Paragraph{fmt::format(
      "First harmonic of the force at {} in phase with the acceleration there, divided by the "
      "first harmonic of that acceleration: m_eq = <F_1, a_1>/<a_1, a_1>.",
      joint)});
  Table table = table_of("", {"case", fmt::format("mass of {}", body.name), "m_eq"});
  const auto kilograms = [](double mass_value) {
    return Cell{text::kilograms(mass_value), mass_value};
  };
  add_row(table, row_of("as it is", kilograms(body.mass), kilograms(mass.given)));
  add_row(table,
          row_of("as it is wanted", kilograms(mass.needed), kilograms(demand.wanted.value())));
  blocks.emplace_back(std::move(table));
  blocks.emplace_back(
      Paragraph{fmt::format("m_eq grows by {} kg per kg of {}.",
                            text::rounded(Quantity::ratio, mass.per_mass), body.name)});
}

}  // namespace

Chapter comparison_chapter(const Source& source) {
  Chapter chapter{"Comparison", {}};
  if (source.level == ReportLevel::summary) return chapter;
  const Verification& verification = source.verification;
  if (verification.chain) add_chain(source.project, *verification.chain, chapter.blocks);
  if (verification.equivalent_mass) {
    add_equivalent_mass(source.project, *verification.equivalent_mass, chapter.blocks);
  }
  return chapter;
}

}  // namespace boxbeam::report
