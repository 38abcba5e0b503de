#include "boxbeam/verification/figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "boxbeam/verification/drawn_histories.hpp"

namespace boxbeam {
namespace {

/// Stations along the beam for drawing, two at every border of the pieces.
std::vector<Station> drawn_stations(const CutForceDiagram& diagram) {
  // Elastic links have many short pieces.
  const int points_per_piece = std::clamp(600 / static_cast<int>(diagram.pieces.size()), 2, 24);
  std::vector<Station> stations{{diagram.pieces.front().start, Side::before}};
  for (const CutForcePiece& piece : diagram.pieces) {
    for (int j = 0; j <= points_per_piece; ++j) {
      const Side side = j == 0 ? Side::behind : (j == points_per_piece ? Side::before : Side::both);
      const Length s =
          j == points_per_piece
              ? piece.end()
              : piece.start + piece.length * (static_cast<double>(j) / points_per_piece);
      stations.push_back({s, side});
    }
  }
  stations.push_back({diagram.pieces.back().end(), Side::behind});
  return stations;
}

}  // namespace

CutForceLine cut_force_line(const SituationRun& run, Time time, const std::string& why) {
  const CutForceDiagram diagram = run.loads.diagram_at(time);
  CutForceLine line{time, why, drawn_stations(diagram), {}};
  for (const Station& station : line.stations) line.values.push_back(diagram.at(station));
  return line;
}

std::vector<CutForceLine> envelope_lines(const std::deque<SituationRun>& runs) {
  const std::vector<Station> stations = drawn_stations(runs.front().loads.diagram(0));
  std::vector<CutForceLine> lines{{Time{}, "smallest", stations, {}},
                                  {Time{}, "largest", stations, {}}};
  const CutForceDiagram first = runs.front().loads.diagram(0);
  for (const Station& station : stations) lines[0].values.push_back(first.at(station));
  lines[1].values = lines[0].values;
  const auto take = [&](std::size_t at, const CutForces& cut) {
    CutForces &low = lines[0].values[at], &high = lines[1].values[at];
    const auto widen = [](auto& least, auto& most, const auto& value) {
      if (value < least) least = value;
      if (most < value) most = value;
    };
    widen(low.N, high.N, cut.N);
    widen(low.V_y, high.V_y, cut.V_y);
    widen(low.V_z, high.V_z, cut.V_z);
    widen(low.T, high.T, cut.T);
    widen(low.M_y, high.M_y, cut.M_y);
    widen(low.M_z, high.M_z, cut.M_z);
  };
  for (const SituationRun& run : runs) {
    const LoadHistory& loads = run.loads;
    // Of records the units are known, of motions each diagram.
    if (loads.is_recorded()) {
      for (std::size_t k = 0; k < stations.size(); ++k)
        for (const CutForces& cut : loads.cuts_at(stations[k])) take(k, cut);
      continue;
    }
    std::vector<std::size_t> pieces(stations.size(), 0);
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      const CutForceDiagram& diagram = loads.kept_diagram(i);
      for (std::size_t k = 0; k < stations.size(); ++k) take(k, diagram.at(stations[k], pieces[k]));
    }
  }
  return lines;
}

LoadsOverTime loads_over_time(const Project& project, const std::deque<SituationRun>& runs,
                              const Station& station) {
  LoadsOverTime figure{station, {}};
  for (const SituationRun& run : runs) {
    LoadsOverTime::Line& line = figure.lines.emplace_back();
    line.situation = index_of(project, *run.situation);
    const std::vector<CutForces> cuts = run.loads.cuts_at(station);
    std::vector<std::function<double(std::size_t)>> each;
    for (const cut_force::Index which : {cut_force::N, cut_force::V_y, cut_force::V_z, cut_force::T,
                                         cut_force::M_y, cut_force::M_z})
      each.emplace_back([&cuts, which](std::size_t i) { return value_of(cuts[i], which); });
    for (const std::size_t i : drawn_samples(cuts.size(), each)) {
      line.times.push_back(run.loads.time_of(i));
      line.values.push_back(cuts[i]);
    }
    if (!run.loads.closed()) continue;
    // What repeats is at its end where it began.
    line.times.push_back(run.loads.begin() + run.loads.period());
    line.values.push_back(line.values.front());
  }
  return figure;
}

namespace {

/// The curves that resist at other places of the beam, each once, the strongest first.
std::vector<SnFigure::Other> other_curves_of(const std::vector<CheckResult>& checks,
                                             const SnCurve& governing,
                                             const std::vector<double>& cycles) {
  std::vector<const SnCurve*> others{&governing};
  for (const CheckResult& result : checks) {
    if (result.check.criterion != Criterion::fatigue || !result.basis) continue;
    const SnCurve& curve = result.basis->curves.front();
    const bool known = std::any_of(others.begin(), others.end(), [&](const SnCurve* of) {
      return of->name == curve.name && of->reference == curve.reference;
    });
    if (!known) others.push_back(&curve);
  }
  others.erase(others.begin());
  std::sort(others.begin(), others.end(),
            [](const SnCurve* a, const SnCurve* b) { return a->reference > b->reference; });
  std::vector<SnFigure::Other> figures;
  for (const SnCurve* curve : others) {
    SnFigure::Other other{curve->name, curve->reference.value(), {}};
    for (const double n : cycles)
      other.spectrum.push_back(strength_at(*curve, n, Loading::spectrum).value());
    figures.push_back(std::move(other));
  }
  return figures;
}

}  // namespace

SnFigure sn_figure(const Project& project, const CheckResult& governing,
                   const std::vector<CheckResult>& checks) {
  const FatigueInput& fatigue = project.fatigue;
  SnFigure figure;
  const SnCurve curve =
      governing.basis ? governing.basis->curves.front() : curve_of(fatigue.beam.detail);
  figure.name = curve.name;
  figure.code = curve.code;
  figure.reference = curve.reference.value();
  figure.published_step = fatigue.published_step;
  for (int i = 0; i <= 120; ++i) {
    const double cycles = std::pow(10.0, 4.0 + 5.0 * i / 120.0);
    figure.cycles.push_back(cycles);
    figure.spectrum.push_back(strength_at(curve, cycles, Loading::spectrum).value());
    figure.constant_amplitude.push_back(
        strength_at(curve, cycles, Loading::constant_amplitude).value());
  }
  if (governing.basis && !figure.published_step)
    figure.others = other_curves_of(checks, curve, figure.cycles);
  figure.knee = knee_of(curve).value();
  figure.cut_off = cut_off_of(curve).value();
  const double gammas = fatigue.demand.gamma_Ff * fatigue.demand.gamma_Mf;
  if (governing.basis) {
    for (const SpectrumRow& row : governing.basis->spectrum) {
      figure.working.emplace_back(row.cycle.count, row.cycle.range.value() * gammas);
    }
  } else {
    figure.working.emplace_back(most_cycles_of(project), governing.check.acting.value() * gammas);
  }
  figure.required = fatigue.required;
  return figure;
}

}  // namespace boxbeam
