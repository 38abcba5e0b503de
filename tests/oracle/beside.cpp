#include "beside.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/mechanism/planar/reactions.hpp"
#include "boxbeam/section/shear_area.hpp"
#include "rules.hpp"
#include "section_stress.hpp"

namespace oracle {

using namespace boxbeam;

std::vector<Run> sample(const Project& project, const std::deque<SituationRun>& runs,
                        int instants) {
  std::vector<Run> sampled;
  for (const SituationRun& of : runs) {
    Run run;
    run.situation = index_of(project, *of.situation);
    run.load_factor = of.situation->load_factor;
    run.closed = of.loads.closed();
    // Frames of random cases bear loads that do not change.
    const bool still = std::holds_alternative<frame::Structure>(project.mechanism);
    const int count = still ? 1 : run.closed ? instants : instants + 1;
    for (int i = 0; i < count; ++i) {
      // A closed history is not met where the program meets it.
      const double part = (i + (run.closed ? 0.37 : 0.0)) / instants;
      run.times.push_back(of.loads.begin() + part * of.loads.period());
      run.diagrams.push_back(of.loads.diagram_at(run.times.back()));
    }
    sampled.push_back(std::move(run));
  }
  return sampled;
}

void look_at_deflection(const Project& project, const std::vector<Run>& sampled,
                        std::set<double> borders, int stations, Findings& found) {
  if (!project.deflection) return;
  const DeflectionInput& input = *project.deflection;
  const double length = project.beam.length().value();
  for (int j = 0; j <= stations; ++j) borders.insert(length * j / stations);
  const std::vector<double> at(borders.begin(), borders.end());
  struct Middle {
    Station station;
    double step, per_N, per_M, per_V;
  };
  std::vector<Middle> middles;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    const Station station{si<Length>(0.5 * (at[i] + at[i + 1])), Side::both};
    LocalSection section;
    section.here = boxbeam::section_at(project.beam, station);
    const Plane plane = plane_of(section, false, false);
    const double E = input.youngs_modulus.value();
    middles.push_back(
        {station, at[i + 1] - at[i], plane.of[0][2] / E, plane.of[1][2] / E,
         1.0 / (input.shear_modulus.value() * shear_areas_of(section.here).z.value())});
  }
  const auto value_at = [&](const std::vector<double>& of, double s) {
    const auto next = std::upper_bound(at.begin(), at.end() - 1, s);
    const auto i = static_cast<std::size_t>(next - at.begin());
    const double part = (s - at[i - 1]) / (at[i] - at[i - 1]);
    return of[i - 1] + part * (of[i] - of[i - 1]);
  };
  for (const Run& run : sampled) {
    const double times = input.load_factor ? run.load_factor : 1.0;
    for (const CutForceDiagram& diagram : run.diagrams) {
      std::vector<double> w{0.0}, theta{0.0};
      for (const Middle& middle : middles) {
        const CutForces cut = diagram.at(middle.station);
        const double turn =
            -middle.step * (middle.per_N * cut.N.value() + middle.per_M * cut.M_y.value());
        w.push_back(w.back() +
                    middle.step * (theta.back() + 0.5 * turn + middle.per_V * cut.V_z.value()));
        theta.push_back(theta.back() + turn);
      }
      double from = 0.0, w_from = 0.0, slope = 0.0;
      if (const auto* chord = std::get_if<Chord>(&input.against)) {
        from = chord->from.value();
        w_from = value_at(w, from);
        slope = (value_at(w, chord->to.value()) - w_from) / (chord->to.value() - from);
      } else {
        from = std::get<Tangent>(input.against).at.value();
        w_from = value_at(w, from);
        slope = value_at(theta, from);
      }
      for (std::size_t i = 0; i < at.size(); ++i) {
        const double off = std::abs(w[i] - w_from - slope * (at[i] - from));
        found.note(Criterion::deflection, times * off / input.limit.value(),
                   {si<Length>(at[i]), Side::both}, "axis");
      }
    }
  }
}

}  // namespace oracle
