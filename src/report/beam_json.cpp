#include "json_parts.hpp"

#include <algorithm>

#include "boxbeam/verification/beam_properties.hpp"
#include "boxbeam/verification/seam_sum.hpp"

namespace boxbeam::report {
namespace {

void put_place(Fields& to, const Station& station) {
  to.number("s", "m", station.s.value());
  to.word("side", to_text(station.side), sides);
}

void put_section(Fields& to, const StationProperties& at) {
  const SectionProperties &gross = at.gross, &net = at.net;
  put_place(to, at.station);
  to.number("height", "m", (gross.z_top - gross.z_bottom).value());
  to.number("width", "m", (gross.y_left - gross.y_right).value());
  to.number("area", "m^2", gross.area.value());
  to.number({"I_y", "bending in the plane of motion"}, "m^4", gross.I_y.value());
  to.number("I_z", "m^4", gross.I_z.value());
  to.number("W_y", "m^3", gross.W_y.value());
  to.number("W_z", "m^3", gross.W_z.value());
  to.number("area_of_holes", "m^2", (gross.area - net.area).value());
  to.object({"net", "holes taken out"}, [&](Fields& of) {
    of.number("area", "m^2", net.area.value());
    of.number("I_y", "m^4", net.I_y.value());
    of.number("W_y", "m^3", net.W_y.value());
  });
  to.number("weight_per_length", "N/m", at.weight.value());
  to.object_or_null("shear_lag", at.shear_lag, [](Fields& of, const ShearLag& lag) {
    of.number("b_0", "m", lag.b_0.value());
    of.number("L_e", "m", lag.effective_length.value());
    of.number("kappa", "1", lag.kappa);
    of.number({"beta", "part of the flanges that works"}, "1", lag.beta);
  });
  to.list({"levels", "the case's points here"}, "{name}", at.levels,
          [](Fields& of, const LevelProperties& level) {
            of.text("name", level.name);
            of.number("z", "m", level.z.value());
            of.number({"first_moment", "of the area beyond"}, "m^3", level.first_moment.value());
            of.number({"width", "of the material cut"}, "m", level.width.value());
          });
}

/// The cut forces that a case looks at; of the description those of every case.
void put_cut_forces(Fields& to, const Project& project, const StationEnvelope& station) {
  const auto put = [&](const char* name, std::size_t which) {
    const Envelope& envelope = station.of[which];
    const double ends[] = {envelope.smallest.value, envelope.largest.value};
    to.numbers(name, which < cut_force::T ? "N" : "N m", ends, {"min", "max"});
  };
  if (!to.is_describing()) {
    for (const auto& [which, name] : cut_forces_looked_at(project)) put(name, which);
    return;
  }
  to.either({{"V", "M"}, {"V_y", "V_z", "T", "M_y", "M_z"}});
  put("N", cut_force::N);
  for (const auto& [name, which] : {std::pair{"V", cut_force::V_z},
                                    {"M", cut_force::M_y},
                                    {"V_y", cut_force::V_y},
                                    {"V_z", cut_force::V_z},
                                    {"T", cut_force::T},
                                    {"M_y", cut_force::M_y},
                                    {"M_z", cut_force::M_z}}) {
    to.optional();
    put(name, which);
  }
}

}  // namespace

void put_beam(Fields& to, const Project& project, const Verification& verification) {
  to.number("length", "m", [&] { return project.beam.length().value(); });
  to.number("mass", "kg", verification.beam_mass.mass.value());
  to.number({"centre_of_mass", "s"}, "m", verification.beam_mass.centre.value());
  to.list({"stations",
           "smallest and largest cut forces over all situations, N, V, M in the plane, "
           "all six in space; two records, - and +, at every jump"},
          "{s}{side}", verification.stations, [&](Fields& of, const StationEnvelope& station) {
            put_place(of, station.station);
            put_cut_forces(of, project, station);
          });
  to.number({"inertia", "about the centre of mass"}, "kg m^2",
            verification.beam_mass.inertia.value());
  to.object({"seams", "between flanges and webs of boxes, all four"}, [&](Fields& of) {
    const SeamSum sum = seams_of(project.beam);
    of.number({"fillet_length", "of those whose throat is said"}, "m", sum.fillets.value());
    of.number({"full_length", "of the others, which penetrate fully"}, "m", sum.full.value());
    of.number({"deposit", "of the fillets: length by the square of the throat"}, "m^3",
              sum.deposit.value());
  });
  to.list(
      {"parts", "between neighbouring named places"}, "{from}-{to}",
      [&] { return parts_of(project.beam); },
      [](Fields& of, const BeamPart& part) {
        of.text("from", part.from);
        of.text("to", part.to);
        of.number("mass", "kg", part.mass.mass.value());
        of.number("centre_from_start", "m", (part.mass.centre - part.start).value());
        of.number("centre_from_end", "m", (part.end - part.mass.centre).value());
        of.number({"inertia", "about its own centre"}, "kg m^2", part.mass.inertia.value());
      });
}

void put_sections(Fields& to, const Project& project, const Verification& verification) {
  to.list(
      {"sections", "at the verified stations, gross where not said otherwise"}, "{s}{side}",
      [&] { return station_properties_of(project, verification.stations, verification.checks); },
      put_section);
}

void put_concentrations(Fields& to, const Verification& verification) {
  struct Concentration {
    std::string hole;
    HoleCase by = HoleCase::in_plane_bending;
    double ratio = 0.0, factor = 0.0;

    bool operator==(const Concentration&) const = default;
  };
  std::vector<Concentration> all;
  const auto add = [&](Concentration of) {
    if (std::find(all.begin(), all.end(), of) == all.end()) all.push_back(std::move(of));
  };
  for (const PublishedConcentration& of : verification.published_concentrations)
    add({of.hole, HoleCase::published_exponential, of.diameter_to_width, of.factor});
  for (const CheckResult& result : verification.checks) {
    if (!result.basis || !result.basis->point.concentration) continue;
    const EdgeConcentration& edge = *result.basis->point.concentration;
    add({edge.hole, edge.edge.hole_case, edge.diameter_to_width, edge.factor});
  }
  to.list({"concentrations", "at the edges of holes"}, "{hole}", all,
          [](Fields& of, const Concentration& at) {
            of.text("hole", at.hole);
            of.text({"case", "which problem it is taken for"}, to_text(at.by));
            of.number("diameter_to_width", "1", at.ratio);
            of.number("factor", "1", at.factor);
          });
}

}  // namespace boxbeam::report
