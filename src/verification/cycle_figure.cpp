#include "boxbeam/verification/cycle_figure.hpp"

#include <algorithm>
#include <cmath>

#include "boxbeam/verification/pictures.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t frames = 48;

/// The places where a load stands at all these instants: those of a joint that slides are not among
/// them.
std::vector<Length> lasting_places_of(const TaperedBeam& beam,
                                      const std::vector<BeamLoads>& instants) {
  const double near = 1e-9 * beam.length().value();
  const auto among = [&](const BeamLoads& loads, Length s) {
    return std::any_of(loads.points.begin(), loads.points.end(), [&](const PointLoad& load) {
      return std::abs((load.s - s).value()) <= near;
    });
  };
  std::vector<Length> places{Length{}, beam.length()};
  for (const PointLoad& load : instants.front().points) {
    const bool known = std::any_of(places.begin(), places.end(), [&](Length place) {
      return std::abs((load.s - place).value()) <= near;
    });
    const bool lasts = std::all_of(instants.begin(), instants.end(),
                                   [&](const BeamLoads& loads) { return among(loads, load.s); });
    if (lasts && !known) places.push_back(load.s);
  }
  std::sort(places.begin(), places.end());
  return places;
}

/// Two stations at every place of a load, and between them so many that the beam has about fifty.
std::vector<Station> stations_between(const std::vector<Length>& places) {
  constexpr double parts_of_beam = 48.0;
  const Length beam = places.back() - places.front();
  std::vector<Station> stations{{places.front(), Side::before}};
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Length span = places[i + 1] - places[i];
    const int parts = std::max(1, static_cast<int>(std::lround(parts_of_beam * (span / beam))));
    stations.push_back({places[i], Side::behind});
    for (int k = 1; k < parts; ++k) {
      stations.push_back({places[i] + span * (static_cast<double>(k) / parts), Side::both});
    }
    stations.push_back({places[i + 1], Side::before});
  }
  stations.push_back({places.back(), Side::behind});
  return stations;
}

/// One value of the cut forces at every station, taken from two of them.
template <class Choose>
CutForces chosen(const CutForces& a, const CutForces& b, const Choose& choose) {
  return {choose(a.N, b.N), choose(a.V_y, b.V_y), choose(a.V_z, b.V_z),
          choose(a.T, b.T), choose(a.M_y, b.M_y), choose(a.M_z, b.M_z)};
}

}  // namespace

CycleFigure cycle_figure_of(const Project& project, const SituationRun& run,
                            const CheckResult* governing, Figures figures) {
  const LoadHistory& history = run.loads;
  const std::size_t steps = history.closed() ? frames : frames - 1;
  std::vector<Time> times;
  std::vector<BeamLoads> loads;
  for (std::size_t i = 0; i < frames; ++i) {
    times.push_back(history.begin() +
                    history.period() * (static_cast<double>(i) / static_cast<double>(steps)));
    loads.push_back(history.loads_at(times.back()));
  }
  CycleFigure figure;
  figure.situation = run.situation->name;
  figure.repeats = history.closed();
  figure.stations = stations_between(lasting_places_of(project.beam, loads));
  const PostureAt posture_at = postures_of(project, run);
  const auto frame_of = [&](Time time, const BeamLoads& loads_then) {
    CycleFrame frame{time, posture_at(time, ""), {}};
    const CutForceDiagram diagram = cut_forces_of(loads_then);
    for (const Station& station : figure.stations) frame.values.push_back(diagram.at(station));
    return frame;
  };
  for (std::size_t i = 0; i < frames; ++i) {
    figure.frames.push_back(frame_of(times[i], loads[i]));
  }
  if (project.in_space && figures == Figures::with_scenes) {
    const bool here =
        governing != nullptr && governing->basis->running == index_of(project, *run.situation);
    std::optional<Time> when;
    // Where loads stand still any instant is the same.
    if (here) when = run.motion->stands_still() ? history.begin() : governing->check.time;
    figure.scene = run.motion->scene(when);
    if (figure.scene && here) {
      figure.critical = CriticalFrame{frame_of(*when, history.loads_at(*when)),
                                      governing->check.station, governing->check.point};
    }
  }
  figure.smallest = figure.largest = figure.frames.front().values;
  const auto take = [&](const CycleFrame& frame) {
    for (std::size_t k = 0; k < figure.stations.size(); ++k) {
      const auto smaller = [](auto a, auto b) { return std::min(a, b); };
      const auto larger = [](auto a, auto b) { return std::max(a, b); };
      figure.smallest[k] = chosen(figure.smallest[k], frame.values[k], smaller);
      figure.largest[k] = chosen(figure.largest[k], frame.values[k], larger);
    }
  };
  for (const CycleFrame& frame : figure.frames) take(frame);
  if (figure.critical) take(figure.critical->frame);
  return figure;
}

}  // namespace boxbeam
