#include <fmt/format.h>

#include <iterator>
#include <set>

#include "boxbeam/report/export.hpp"
#include "csv_cells.hpp"

namespace boxbeam {
namespace {

using report::csv_cell;

/// Numbers in lines of at most sixteen.
template <class Range, class Number>
void put_numbers(std::string& text, const Range& range, const Number& number) {
  std::size_t in_line = 0;
  for (const auto& of : range) {
    text += fmt::format("{}{}", in_line == 0 ? "" : ", ", number(of));
    if (++in_line == 12) {
      text += ",\n";
      in_line = 0;
    }
  }
  if (in_line > 0) text += "\n";
}

}  // namespace

std::string shells_inp(const ShellModel& model, const Project& project, const std::string& title) {
  std::string one_line = title.substr(0, 500);
  for (char& c : one_line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  std::string text = fmt::format(
      "** {}\n** m, N, Pa; x along the beam, y to the left, z upwards. Run: ccx beam\n"
      "** The loads are in balance: the reactions of what is held are zero.\n"
      "** Stresses are printed in the axes of each shell: along the beam, then around the "
      "profile,\n"
      "** to the left at the bottom and up in the left web.\n",
      one_line);
  for (const std::string& words : model.simplified) text += fmt::format("** {}\n", words);
  text += "*NODE, NSET=NALL\n";
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    const Eigen::Vector3d& at = model.nodes[i];
    text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", i + 1, at.x(), at.y(), at.z());
  }
  for (std::size_t set = 0; set < model.sets.size(); ++set) {
    text += fmt::format("*ELEMENT, TYPE=S8R, ELSET={}\n", model.sets[set].name);
    for (std::size_t e = 0; e < model.elements.size(); ++e) {
      const ShellElement& element = model.elements[e];
      if (element.set != set) continue;
      text += fmt::format("{}", e + 1);
      for (const std::size_t node : element.nodes) text += fmt::format(", {}", node + 1);
      text += "\n";
    }
  }
  text += "*ELSET, ELSET=EALL\n";
  for (const ShellSet& set : model.sets) text += set.name + "\n";
  const double E = project.model.youngs_modulus, G = project.model.shear_modulus;
  text += fmt::format("*MATERIAL, NAME=STEEL\n*ELASTIC\n{:.9g}, {:.9g}\n*DENSITY\n{:.9g}\n", E,
                      0.5 * E / G - 1.0, project.beam.density.value());
  for (const ShellSet& set : model.sets)
    text +=
        fmt::format("*SHELL SECTION, ELSET={}, MATERIAL=STEEL\n{:.12g}\n", set.name, set.thickness);
  std::size_t free_node = model.nodes.size();
  for (std::size_t i = 0; i < model.rigid.size(); ++i) {
    text += fmt::format("*NSET, NSET=RIGID{}\n", i + 1);
    put_numbers(text, model.rigid[i], [](std::size_t node) { return node + 1; });
    const double s = model.nodes[model.rigid[i].front()].x();
    text += fmt::format("*NODE\n{}, {:.12g}, 0, 0\n{}, {:.12g}, 0, 0\n", free_node + 1, s,
                        free_node + 2, s);
    text += fmt::format("*RIGID BODY, NSET=RIGID{}, REF NODE={}, ROT NODE={}\n", i + 1,
                        free_node + 1, free_node + 2);
    free_node += 2;
  }
  text += "*BOUNDARY\n";
  for (const HeldFreedom& held : model.held)
    text += fmt::format("{}, {}, {}\n", held.node + 1, held.direction + 1, held.direction + 1);
  text += "*NSET, NSET=HELD\n";
  std::set<std::size_t> held_nodes;
  for (const HeldFreedom& held : model.held) held_nodes.insert(held.node);
  put_numbers(text, held_nodes, [](std::size_t node) { return node + 1; });
  text += "*STEP\n*STATIC\n*CLOAD\n";
  for (const NodalForce& of : model.forces) {
    for (int k = 0; k < 3; ++k) {
      if (of.force[k] != 0.0)
        text += fmt::format("{}, {}, {:.15g}\n", of.node + 1, k + 1, of.force[k]);
    }
  }
  text +=
      "*NODE FILE\nU\n*EL FILE\nS\n*NODE PRINT, NSET=HELD\nRF\n*EL PRINT, ELSET=EALL\nS\n"
      "*END STEP\n";
  return text;
}

std::string shells_csv(const ShellModel& model) {
  std::string text =
      "element,set,part,s [m],y [m],z [m],thickness [m],normal stress [Pa],shear stress [Pa],"
      "shear stress in the section [Pa]\n";
  for (std::size_t e = 0; e < model.elements.size(); ++e) {
    const ShellElement& of = model.elements[e];
    const ShellSet& set = model.sets[of.set];
    text += report::csv_row(
        {fmt::format("{}", e + 1), set.name, part_names[static_cast<std::size_t>(of.part)],
         csv_cell(of.centre.s.value()), csv_cell(of.y), csv_cell(of.z), csv_cell(set.thickness),
         csv_cell(of.stress.normal.value()), csv_cell(of.stress.shear.value()),
         csv_cell(of.shear_in_section.value())});
  }
  return text;
}

}  // namespace boxbeam
