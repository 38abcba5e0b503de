#include <fmt/format.h>

#include <iterator>

#include "boxbeam/report/export.hpp"
#include "csv_cells.hpp"

namespace boxbeam {
namespace {

using report::csv_cell;

/// A scalar of every point or cell.
template <class Value>
void put_scalars(std::string& text, const char* name, const char* type, std::size_t count,
                 const Value& value) {
  text += fmt::format("SCALARS {} {} 1\nLOOKUP_TABLE default\n", name, type);
  for (std::size_t i = 0; i < count; ++i) text += value(i) + "\n";
}

}  // namespace

std::string plates_vtk(const PlateField& field, const std::string& title) {
  const std::size_t plates = field.nodes.size(), axis = field.axis.size();
  std::string one_line = title.substr(0, 255);
  for (char& c : one_line) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  std::string text = fmt::format(
      "# vtk DataFile Version 3.0\n{}\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
      one_line, plates + axis);
  for (const PlateNode& node : field.nodes)
    text += fmt::format("{} {} {}\n", node.place.x(), node.place.y(), node.place.z());
  for (const AxisNode& node : field.axis) text += fmt::format("{} 0 0\n", node.station.s.value());
  // The axis as lines one behind the other, which more readers know than a single one of many
  // points.
  std::vector<std::size_t> lines;
  for (std::size_t i = 1; i < axis; ++i) {
    if (field.axis[i].station.s != field.axis[i - 1].station.s) lines.push_back(plates + i - 1);
  }
  const std::size_t quads = field.quads.size(), cells = quads + lines.size();
  text += fmt::format("CELLS {} {}\n", cells, 5 * quads + 3 * lines.size());
  for (const PlateQuad& quad : field.quads)
    text += fmt::format("4 {}\n", fmt::join(quad.nodes, " "));
  for (const std::size_t first : lines) text += fmt::format("2 {} {}\n", first, first + 1);
  constexpr const char *quad_type = "9\n", *line_type = "3\n";
  text += fmt::format("CELL_TYPES {}\n", cells);
  for (std::size_t i = 0; i < cells; ++i) text += i < quads ? quad_type : line_type;

  text += fmt::format("POINT_DATA {}\n", plates + axis);
  const auto stress = [&](const char* name, const auto& of) {
    put_scalars(text, name, "double", plates + axis, [&](std::size_t i) {
      return i < plates ? csv_cell(of(field.nodes[i].stress).value()) : std::string("0");
    });
  };
  stress("normal_stress_Pa", [](const PointStress& at) { return at.normal; });
  stress("shear_stress_Pa", [](const PointStress& at) { return at.shear; });
  stress("von_Mises_Pa", [](const PointStress& at) { return at.von_mises(); });
  constexpr std::array names{"N_N", "V_y_N", "V_z_N", "T_Nm", "M_y_Nm", "M_z_Nm"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    put_scalars(text, names[k], "double", plates + axis, [&](std::size_t i) {
      return i < plates
                 ? std::string("0")
                 : csv_cell(value_of(field.axis[i - plates].cut, static_cast<cut_force::Index>(k)));
    });
  }
  text += fmt::format("CELL_DATA {}\n", cells);
  const auto of_cell = [&](const char* name, const char* type, const auto& of) {
    put_scalars(text, name, type, cells, [&](std::size_t i) {
      return i < quads ? fmt::format("{}", of(field.quads[i])) : std::string("0");
    });
  };
  of_cell("thickness_m", "double", [](const PlateQuad& quad) { return quad.thickness; });
  of_cell("part", "int", [](const PlateQuad& quad) { return quad.part; });
  of_cell("segment", "int", [](const PlateQuad& quad) { return quad.segment; });
  of_cell("inner", "int", [](const PlateQuad& quad) { return quad.inner ? 1 : 0; });
  return text;
}

}  // namespace boxbeam
