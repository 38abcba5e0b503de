#include "beam_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/report/format.hpp"
#include "boxbeam/section/torsion.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

using layout::heading;
using layout::Table;

std::string planar_loads(const Verification& verification) {
  std::string out =
      "  Forces of the joints on the beam; world axes x right, y up; beam axes x along the axis,\n"
      "  z its left normal. Weight and inertia act per length in between.\n\n";
  Table table(
      {"t [s]", "at", "s [m]", "F_x world", "F_y world", "F_x beam", "F_z beam", "couple M_y"});
  for (const BeamLoadRow& row : verification.loads) {
    table.row({fmt::format("{:.4f}", row.time.value()), row.name,
               text::significant(row.s.value(), 4), text::kN(row.world.x()),
               text::kN(row.world.y()), text::kN(row.force.x()), text::kN(row.force.z()),
               std::abs(row.moment.y()) < 1e-6 ? "0" : text::kNm(row.moment.y())});
  }
  return out + table.text();
}

/// A table for every critical instant: what each joint and load does to the beam.
std::string spatial_loads(const Project& project, const Verification& verification) {
  std::string out = layout::paragraph(
      "What joints and loads do to the beam; forces in world axes, then forces and moments about "
      "the axis in beam axes: x along the axis, y and z as the cut forces. Weight, inertia and "
      "line forces act per length in between.");
  for (std::size_t k = 1; k < verification.postures.size(); ++k) {
    const PostureFigure& posture = verification.postures[k];
    out += fmt::format("\n  t = {}: {}\n", text::seconds(posture.time.value()), posture.why);
    Table table({"by", "s [m]", "world F_x", "F_y", "F_z [kN]", "beam F_x", "F_y", "F_z [kN]",
                 "beam M_x", "M_y", "M_z [kN m]"});
    double force = 0.0;
    for (const BeamLoadRow& row : posture.loads) force = std::max(force, row.force.norm());
    const double moment = force * project.beam.length().value();
    const auto add = [](std::vector<std::string>& cells, const Eigen::Vector3d& v, double size) {
      for (const double x : v) {
        cells.push_back(std::abs(x) <= 1e-9 * size ? "0" : text::significant(x * 1e-3));
      }
    };
    for (const BeamLoadRow& row : posture.loads) {
      std::vector<std::string> cells{row.name, text::significant(row.s.value(), 4)};
      add(cells, row.world, force);
      add(cells, row.force, force);
      add(cells, row.moment, moment);
      table.row(std::move(cells));
    }
    out += table.text();
  }
  return out;
}

/// The stress points of the checks, one for every station, in order along the beam.
std::vector<const StressPoint*> points_per_station(const Verification& verification) {
  std::vector<const StressPoint*> points;
  for (const CheckResult& result : verification.checks) {
    if (!result.basis) continue;
    const StressPoint& point = result.basis->point;
    const bool known = std::any_of(points.begin(), points.end(), [&](const StressPoint* other) {
      return other->station == point.station;
    });
    if (!known) points.push_back(&point);
  }
  std::sort(points.begin(), points.end(), [](const StressPoint* a, const StressPoint* b) {
    return std::pair(a->station.s, a->station.side) < std::pair(b->station.s, b->station.side);
  });
  return points;
}

}  // namespace

std::string loads_section(const Project& project, const Verification& verification) {
  std::string out = heading("Loads on the beam at the critical instants");
  out += in_space(project) ? spatial_loads(project, verification) : planar_loads(verification);
  double imbalance = 0.0;
  for (const MotionSummary& motion : verification.motions) {
    imbalance = std::max(imbalance, motion.imbalance);
  }
  out += fmt::format("\n  balance of all loads on the beam: {:.1e} of the largest force\n\n",
                     imbalance);
  return out;
}

std::string cut_force_section(const Project& project, const Verification& verification) {
  std::string out = heading("Cut forces, smallest and largest over the period");
  out += in_space(project)
             ? "  N tension positive, V_y and V_z along +y and +z, T about +x, M_y > 0 puts +z in "
               "tension, M_z > 0 -y;\n  - and + are the two sides of a jump.\n\n"
             : "  N tension positive, V along +z, M > 0 puts +z in tension; - and + are the two "
               "sides of a jump.\n\n";
  std::vector<std::string> titles{"s [m]"};
  for (const auto& [which, name] : cut_forces_looked_at(project)) {
    titles.push_back(fmt::format("{} min", name));
    titles.push_back(fmt::format("{} max [{}]", name, which < cut_force::T ? "kN" : "kN m"));
  }
  Table table(titles);
  const auto k = [](double x) { return std::abs(x) < 1e-6 ? "0" : text::significant(x * 1e-3); };
  for (const StationEnvelope& station : verification.stations) {
    std::vector<std::string> row{to_text(station.station)};
    for (const auto& [which, name] : cut_forces_looked_at(project)) {
      row.push_back(k(station.of[which].smallest.value));
      row.push_back(k(station.of[which].largest.value));
    }
    table.row(row);
  }
  out += table.text() + "\n";
  const bool several = in_space(project) && project.situations.size() > 1;
  Table instants(
      several ? std::vector<std::string>{"extreme of", "s [m]", "t [s]", "value", "situation"}
              : std::vector<std::string>{"extreme of", "s [m]", "t [s]", "value"});
  for (const CriticalInstant& instant : verification.critical_instants) {
    const bool moment = instant.quantity.starts_with("M") || instant.quantity == "T";
    const std::string value = moment                         ? text::kNm(instant.value)
                              : instant.quantity == "stress" ? text::MPa(instant.value)
                                                             : text::kN(instant.value);
    std::vector<std::string> row{instant.quantity, to_text(instant.station),
                                 fmt::format("{:.6f}", instant.time.value()), value};
    if (several) row.push_back(project.situations[instant.situation].name);
    instants.row(std::move(row));
  }
  return out + instants.text() + "\n";
}

std::string section_section(const Project& project, const Verification& verification) {
  const std::vector<const StressPoint*> points = points_per_station(verification);
  if (points.empty()) return "";
  const auto e = [](double x) { return fmt::format("{:.4e}", x); };
  const auto mm = [](Length x) { return text::significant(x.value() * 1e3, 4); };
  if (!in_space(project)) {
    Table table({"s [m]", "h [mm]", "A [mm^2]", "I_y [mm^4]", "W_y [mm^3]", "A_net [mm^2]",
                 "I_y,net [mm^4]"});
    for (const StressPoint* point : points) {
      table.row({to_text(point->station), mm(2.0 * point->gross.z_top),
                 e(point->gross.area.value() * 1e6), e(point->gross.I_y.value() * 1e12),
                 e(point->gross.W_y.value() * 1e9), e(point->net.area.value() * 1e6),
                 e(point->net.I_y.value() * 1e12)});
    }
    return heading("Sections") + table.text() + "\n";
  }
  Table table({"s [m]", "h [mm]", "b [mm]", "A [mm^2]", "I_y [mm^4]", "I_z [mm^4]", "I_T [mm^4]",
               "W_y [mm^3]", "W_z [mm^3]", "A_net [mm^2]"});
  for (const StressPoint* point : points) {
    const SectionProperties& gross = point->gross;
    const std::optional<SecondMoment> I_T = torsion_properties_of(point->section).I_T;
    table.row({to_text(point->station), mm(gross.z_top - gross.z_bottom),
               mm(gross.y_left - gross.y_right), e(gross.area.value() * 1e6),
               e(gross.I_y.value() * 1e12), e(gross.I_z.value() * 1e12),
               I_T ? e(I_T->value() * 1e12) : "not known", e(gross.W_y.value() * 1e9),
               e(gross.W_z.value() * 1e9), e(point->net.area.value() * 1e6)});
  }
  return heading("Sections") + table.text() + "\n";
}

}  // namespace boxbeam
