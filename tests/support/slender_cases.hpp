#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "boxbeam/verification/plate_checks.hpp"
#include "boxbeam/verification/verify.hpp"
#include "catch.hpp"
#include "support/gates.hpp"

/// Cantilevers of slender boxes as cases, and what their verification says of them.
namespace slender_cases {

using namespace boxbeam;
using test::has_gate;

inline std::string box(const std::string& name, double width, double height, double flange,
                       double web, const std::string& more = "") {
  return fmt::format(
      "[sections.{}]\nkind = \"box\"\nwidth = \"{:.17g} mm\"\nheight = \"{:.17g} mm\"\n"
      "flange = \"{:.17g} mm\"\nweb = \"{:.17g} mm\"\n{}",
      name, width, height, flange, web, more);
}

inline const std::string steel = "[material]\nsteel = \"S355\"\nfy_source = \"EN 1993-1-1\"\n";
/// Judged in fatigue: the force at the tip comes and goes a thousand times.
inline const std::string lifted_often =
    "[fatigue]\ncategory = 160\nloading = \"spectrum\"\ngamma_Mf = 1.0\nrequired = 1.0\n"
    "[[situations]]\nname = \"on\"\nloads = { tip = 1.0 }\n"
    "[[situations]]\nname = \"off\"\nloads = { tip = 0.0 }\n"
    "[[situations]]\nname = \"lift\"\nbetween = [\"on\", \"off\"]\ncycles = 1000\n";

/// A cantilever at rest without weight, with forces at its tip.
inline std::string cantilever(const std::string& sections, const std::string& segments,
                              const std::string& loads, const std::string& frame = "",
                              const std::string& strength = "") {
  const bool space = frame.find("space") != std::string::npos;
  const std::string nothing = space ? "gravity = [\"0 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n"
                                    : "gravity = [\"0 m/s^2\", \"0 m/s^2\"]\n";
  return "[case]\nname = \"slender\"\nkind = \"static\"\n[frame]\n" + frame + nothing + sections +
         "[beam]\ndensity = \"7850 kg/m^3\"\n" + segments +
         "[supports.root]\nkind = \"fixed\"\nat = \"0 m\"\n" + loads + steel +
         "[strength]\nrequired = 1.0\nshear_lag = false\n" + strength;
}

inline std::string segment(double length, const std::string& section) {
  return fmt::format("[[beam.segments]]\nlength = \"{:.17g} m\"\nsection = \"{}\"\n", length,
                     section);
}

inline std::string taper(double length, const std::string& from, const std::string& to) {
  return fmt::format("[[beam.segments]]\nlength = \"{:.17g} m\"\nfrom = \"{}\"\nto = \"{}\"\n",
                     length, from, to);
}

inline std::string tip(double at, double V, double N = 0.0) {
  return fmt::format(
      "[loads.tip]\nkind = \"force\"\nat = \"{:.17g} m\"\nforce = [\"{:.17g} kN\", \"{:.17g} "
      "kN\"]\n",
      at, N, V);
}

inline Verification verified(const std::string& text) {
  return verify(parse_project("slender.toml", text));
}

inline double use_of(const Verification& of, Criterion criterion) {
  const CheckResult* const found = of.governing(criterion);
  return found == nullptr ? 0.0 : found->check.utilisation();
}

inline double shear_resistance_in(const Verification& of) {
  const CheckResult* const shear = of.governing(Criterion::shear_buckling);
  REQUIRE(shear != nullptr);
  return shear->check.resisting.value();
}

/// Mean shear stress of both flanges under V_z, as their checks count it.
inline void check_flanges_under(double V, const SlenderPlates& plates, double stress,
                                double within) {
  CutForces cut{};
  cut.V_z = si<Force>(V);
  int flanges = 0;
  for (const ShearedPlate& plate : plates.sheared) {
    if (!is_flange(plate.plate)) continue;
    CHECK((plate.force_of(cut) / (plate.panel.depth * plate.panel.thickness)).value() ==
          Approx(stress).epsilon(within));
    ++flanges;
  }
  CHECK(flanges == 2);
}

inline std::string diaphragms(const std::vector<double>& at, double thickness = 10.0,
                              double opening = 0.0) {
  std::string text;
  for (const double s : at) {
    text += fmt::format("[[beam.diaphragms]]\nstation = \"{:.17g} m\"\nthickness = \"{} mm\"\n", s,
                        thickness);
    if (opening > 0.0) text += fmt::format("opening = \"{} mm\"\n", opening);
  }
  return text;
}

/// Flats on a plate of a section, by their places in mm.
inline std::string flats(const std::string& section, const std::string& plate,
                         const std::vector<double>& places, double depth, double thickness) {
  std::string text;
  for (const double at : places) {
    text += fmt::format(
        "[[sections.{}.stiffeners]]\non = \"{}\"\nat = \"{:.17g} mm\"\ndepth = \"{:.17g} mm\"\n"
        "thickness = \"{:.17g} mm\"\n",
        section, plate, at, depth, thickness);
  }
  return text;
}

/// Looks at the plates of so many stations one by one: none is used more than what is reported.
/// How many had plates that may buckle.
inline int look_along(const Project& project, int steps) {
  const Verification of = verify(project);
  const auto runs = run_situations(project, of.model.chosen);
  const auto zones = bending_zones_of(project, runs);
  std::array<double, plate_criteria.size()> most{};
  int judged = 0;
  for (int k = 0; k <= steps; ++k) {
    const Length s = project.beam.length() * (static_cast<double>(k) / steps);
    const Station station{s, Side::both};
    const auto plates = slender_plates_at(project, zones, station);
    if (!plates) continue;
    const auto histories = histories_at(runs, station);
    for (const CheckResult& check : check_plates(project, station, plates, histories).checks) {
      for (std::size_t c = 0; c < most.size(); ++c) {
        if (check.check.criterion == plate_criteria[c])
          most[c] = std::max(most[c], check.check.utilisation());
      }
    }
    ++judged;
  }
  for (std::size_t c = 0; c < most.size(); ++c) {
    CAPTURE(c);
    // What another check says as well is left out.
    double reported = use_of(of, plate_criteria[c]);
    if (plate_criteria[c] != Criterion::shear_buckling) {
      reported = std::max(
          {reported, use_of(of, Criterion::effective_section), use_of(of, Criterion::yield)});
    }
    if (plate_criteria[c] == Criterion::interaction)
      reported = std::max(reported, use_of(of, Criterion::shear_buckling));
    CHECK(most[c] <= reported * (1.0 + 1e-3));
  }
  return judged;
}

}  // namespace slender_cases
