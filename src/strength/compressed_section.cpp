#include "boxbeam/strength/compressed_section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/section/section_properties.hpp"
#include "boxbeam/strength/effective_path.hpp"
#include "boxbeam/strength/plate_slenderness.hpp"
#include "plate_formulas.hpp"

namespace boxbeam {
namespace {

/// Thickness of the flanges and of the webs of a profile whose slender plates leave its centroid
/// where it is; nothing of others.
struct Walls {
  Length flange, web;
};

std::optional<Walls> symmetric_walls_of(const Profile& profile) {
  if (const auto* tube = std::get_if<RectangularTube>(&profile))
    return Walls{tube->wall, tube->wall};
  const auto* box = std::get_if<Box>(&profile);
  if (box == nullptr || !box->stiffeners.empty() || box->left_web != box->right_web ||
      box->top_flange != box->bottom_flange) {
    return std::nullopt;
  }
  return Walls{box->top_flange, box->left_web};
}

bool is_convex(const std::vector<SectionPlace>& loop) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const SectionPlace& a = loop[i];
    const SectionPlace& b = loop[(i + 1) % loop.size()];
    const SectionPlace& c = loop[(i + 2) % loop.size()];
    const double turn = ((b.y - a.y) * (c.z - b.z) - (b.z - a.z) * (c.y - b.y)).value();
    left = left || turn > 0.0;
    right = right || turn < 0.0;
  }
  return left != right;
}

/// Why no plate of a profile can be judged, whatever its slenderness.
std::string obstacle_of(const Profile& profile) {
  if (const auto* solid = std::get_if<Polygon>(&profile);
      solid != nullptr && (!solid->hollows.empty() || !is_convex(solid->outer))) {
    return "the walls of a polygon that is hollow or not convex are not known, and so its class is "
           "not";
  }
  return "";
}

std::string beyond_text(const CompressedPlate& plate, const char* why) {
  return fmt::format("{}: {} = {:.3g} is above {:.3g}, class 4 (EN 1993-1-1, table 5.2), and {}",
                     plate.name, plate.round ? "d/t" : "c/t", plate.ratio, plate.limit, why);
}

/// What is not effective of both plates of a name under even compression.
template <class Value, class Number>
struct IdlePart {
  Number lambda_p, rho;
  Value idle;
};
template <class Value, class Number>
IdlePart(Number, Number, Value) -> IdlePart<Value, Number>;

template <class Record, class Number>
auto idle_part_of(Record& record, const CompressedPlate& plate, const Number& epsilon,
                  Symbol symbol) {
  const auto c = record.given("c", Length(plate.ratio * plate.thickness));
  record.note([&] { return plate.name; });
  const auto t = record.given("t", plate.thickness);
  const auto k_sigma = plate.outstand ? record.constant("0.43", 0.43) : record.constant("4", 4.0);
  const auto lambda_p = plate::slenderness(record, c / t, epsilon, k_sigma);
  record.note([&] {
    return plate.outstand ? "k_sigma = 0.43: outstand in even compression (EN 1993-1-5, 4.4)"
                          : "k_sigma = 4: even compression (EN 1993-1-5, 4.4)";
  });
  const auto rho = plate.outstand
                       ? plate::outstand_reduction(record, lambda_p)
                       : plate::internal_reduction(record, lambda_p, record.constant("1", 1.0));
  record.note([] { return "psi = 1"; });
  const auto one = (c - rho * c) * t;
  const auto idle = record.define(symbol, plate.alike == 2 ? 2.0 * one : one);
  record.note([&] {
    return (plate.alike == 2 ? "not effective of both plates, " : "not effective of ") + plate.name;
  });
  return IdlePart{lambda_p, rho, idle};
}

/// Takes what is not effective out of a plate beyond class 3.
void reduce(CompressedPlate& plate, Length thickness, double epsilon) {
  plate.thickness = thickness;
  const auto part = idle_part_of(plainly, plate, Dimensionless(epsilon), "A_c");
  plate.lambda_p = part.lambda_p;
  plate.rho = part.rho;
  plate.idle = part.idle;
}

/// Why the effective area of a path in class 4 is not taken, "" where it is.
std::string path_obstacle(const PathSection& section) {
  for (const PathPlate& of : section.plates) {
    if (!may_buckle(of)) continue;
    if (std::string why = width_obstacle(of); !why.empty()) return why;
    const auto differs = [&](const PathPlate::Part& part) {
      return std::abs(section.graph.walls[part.wall].thickness / of.thickness.value() - 1.0) > 1e-9;
    };
    if (std::any_of(of.parts.begin(), of.parts.end(), differs))
      return of.name + ": its thickness changes along it";
  }
  return "";
}

/// Says by how much the centroid of a path moves; why that is not counted of one with another
/// profile.
void move_centroid(const PathSection& section, bool alone, CompressedSection& result) {
  const AreaSums left = path_alone(section, ActingAlone::compression).sums;
  const EffectiveCentroid moved =
      effective_centroid_of(section.gross, left, 1e-9 * std::sqrt(section.gross.area));
  if (alone) {
    result.shift_y = moved.shift_y;
    result.shift_z = moved.shift_z;
    return;
  }
  const double shift = std::hypot(moved.shift_y.value(), moved.shift_z.value());
  if (!(shift > 0.0)) return;
  result.obstacle = fmt::format(
      "its effective centroid moves by {:.3g} mm (EN 1993-1-5, 4.3(3)), and what "
      "that bends is not counted",
      1e3 * shift);
}

/// The plates of a path in class 4; false where it is none.
bool add_slender_path(const ThinWalled& path, Stress yield_strength, bool alone,
                      CompressedSection& result) {
  // All plates are judged by the section's own.
  const Material steel = steel_of(yield_strength);
  const PathSection section = *path_section_of(path, steel);
  if (std::none_of(section.plates.begin(), section.plates.end(),
                   [](const PathPlate& of) { return may_buckle(of); }))
    return false;
  const double epsilon = epsilon_of(yield_strength);
  result.class_4 = true;
  if (result.obstacle.empty()) result.obstacle = path_obstacle(section);
  if (result.obstacle.empty()) move_centroid(section, alone, result);
  for (const PathPlate& of : section.plates) {
    CompressedPlate plate;
    plate.name = of.name;
    plate.ratio = of.clear() / of.thickness;
    plate.outstand = of.outstand();
    plate.limit = plate.outstand ? outstand_flange_limits(epsilon).class_3
                                 : internal_part_limits(1.0, 1.0, epsilon).class_3;
    plate.alike = 1;
    if (result.obstacle.empty() && may_buckle(of)) reduce(plate, of.thickness, epsilon);
    result.plates.push_back(std::move(plate));
  }
  return true;
}

void add_plates(const Profile& profile, Stress yield_strength, bool alone,
                CompressedSection& result) {
  if (result.obstacle.empty()) result.obstacle = obstacle_of(profile);
  if (const auto* const path = std::get_if<ThinWalled>(&profile);
      path != nullptr && add_slender_path(*path, yield_strength, alone, result))
    return;
  const double epsilon = epsilon_of(yield_strength);
  const double compressed = internal_part_limits(1.0, 1.0, epsilon).class_3;
  const bool round = std::holds_alternative<RoundTube>(profile);
  const std::optional<Walls> walls = symmetric_walls_of(profile);
  for (const SlenderPlate& of : plate_slenderness_of(profile, steel_of(yield_strength))) {
    CompressedPlate plate;
    plate.name = of.plate;
    plate.round = round;
    plate.ratio = of.ratio;
    plate.limit = of.limit;
    // A web is listed with its limit in bending; here it is compressed all over.
    if (!round) plate.limit = std::min(of.limit, compressed);
    if (plate.ratio > plate.limit) {
      result.class_4 = true;
      if (walls) {
        reduce(plate, of.plate == "flange" ? walls->flange : walls->web, epsilon);
      } else if (result.obstacle.empty()) {
        result.obstacle = beyond_text(
            plate, round ? "a round tube so thin is a shell (EN 1993-1-6)"
                         : "the effective area of a section that is stiffened or not doubly "
                           "symmetric is not computed (EN 1993-1-5, 4.3(3))");
      }
    }
    result.plates.push_back(std::move(plate));
  }
}

}  // namespace

CompressedSection compressed_section_of(const Section& section, Stress yield_strength) {
  CompressedSection result;
  result.area = properties_of(section).area;
  const bool alone = !section.inner;
  add_plates(section.outer, yield_strength, alone, result);
  if (section.inner) add_plates(*section.inner, yield_strength, alone, result);
  result.effective = result.area;
  for (const CompressedPlate& plate : result.plates) result.effective -= plate.idle;
  return result;
}

Traced derive_effective_area(Derivation& steps, const CompressedSection& section,
                             Stress yield_strength) {
  Traced A = steps.given("A", section.area);
  if (section.plates.empty()) return A;
  const Traced epsilon = plate::epsilon(steps, steps.known("f_y", yield_strength));
  const CompressedPlate& worst = *std::max_element(
      section.plates.begin(), section.plates.end(),
      [](const auto& a, const auto& b) { return a.ratio / a.limit < b.ratio / b.limit; });
  steps.given(worst.round ? "d/t" : "c/t", worst.ratio, {});
  steps.note(
      [&] {
        return fmt::format("{}, of class 3 or better up to {{}} (EN 1993-1-1, table 5.2){}",
                           worst.name, section.class_4 ? ": class 4" : "");
      },
      steps.known("limit", worst.limit));
  if (!section.class_4) return A;
  const auto slender = [](const CompressedPlate& plate) { return plate.rho != 1.0; };
  const bool several = std::count_if(section.plates.begin(), section.plates.end(), slender) > 1;
  Traced left = A;
  int number = 0;
  for (const CompressedPlate& plate : section.plates) {
    if (!slender(plate)) continue;
    const std::string index = several ? std::to_string(++number) : "";
    left = left - idle_part_of(steps, plate, epsilon, {"A_c", index}).idle;
  }
  return steps.define("A_eff", left, "A less what is idle");
}

}  // namespace boxbeam
