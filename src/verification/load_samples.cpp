#include "boxbeam/verification/load_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "boxbeam/verification/front_end.hpp"

namespace boxbeam {
namespace {

/// Of the largest force or moment: how far a chord between stations may be from the cut force, and
/// one between instants.
constexpr double chord_tolerance = 1e-5;
/// Parts of a stretch, or of a step of time, at most.
constexpr int most_parts = 100;
/// Stations within stretches and instants of a situation, beyond which chords may be coarser: every
/// station is verified at every instant.
constexpr int most_stations = 120;
constexpr std::size_t most_instants = 4000;
/// Instants of a situation at which stations are chosen and errors measured, about.
constexpr std::size_t looked_at = 200;

constexpr std::array quarters{0.25, 0.5, 0.75};

/// The largest force and moment of all, by which errors are measured.
struct Scale {
  double force = 0.0, moment = 0.0;

  SamplingError of(const CutForces& a, const CutForces& b) const {
    SamplingError error;
    for (std::size_t k = 0; k < cut_force::count; ++k) {
      const auto which = static_cast<cut_force::Index>(k);
      const double apart = std::abs(value_of(a, which) - value_of(b, which));
      double& to = which < cut_force::T ? error.force : error.moment;
      to = std::max(to, apart);
    }
    if (force > 0.0) error.force /= force;
    if (moment > 0.0) error.moment /= moment;
    return error;
  }
};

double larger(const SamplingError& error) { return std::max(error.force, error.moment); }

void take_larger(const SamplingError& other, SamplingError& error) {
  error.force = std::max(error.force, other.force);
  error.moment = std::max(error.moment, other.moment);
}

CutForces between(const CutForces& a, const CutForces& b, double part) {
  const auto mix = [&](auto x, auto y) { return (1.0 - part) * x + part * y; };
  return {mix(a.N, b.N), mix(a.V_y, b.V_y), mix(a.V_z, b.V_z),
          mix(a.T, b.T), mix(a.M_y, b.M_y), mix(a.M_z, b.M_z)};
}

int parts_for(double error) {
  return std::clamp(static_cast<int>(std::ceil(std::sqrt(error / chord_tolerance))), 1, most_parts);
}

/// Borders of a diagram's pieces.
std::vector<double> borders_of(const CutForceDiagram& diagram) {
  std::vector<double> borders;
  for (const CutForcePiece& piece : diagram.pieces) {
    borders.push_back(piece.start.value());
    borders.push_back(piece.end().value());
  }
  std::sort(borders.begin(), borders.end());
  return borders;
}

class Sampling {
 public:
  Sampling(const Project& project, const std::deque<SituationRun>& runs,
           const Verification& verification)
      : project_(&project), runs_(&runs), verification_(&verification) {
    for (const SituationRun& run : runs) {
      scale_.force = std::max(scale_.force, run.loads.largest_force());
      scale_.moment = std::max(scale_.moment, run.loads.largest_moment());
      std::vector<CutForceDiagram>& some = looked_at_.emplace_back();
      const std::size_t step = std::max<std::size_t>(1, run.loads.instants() / looked_at);
      for (std::size_t i = 0; i < run.loads.instants(); i += step)
        some.push_back(run.loads.diagram(i));
    }
  }

  LoadSamples take() {
    LoadSamples samples;
    samples.slides = slides();
    if (samples.slides) return samples;
    choose_stations(samples);
    for (const SituationRun& run : *runs_) samples.situations.push_back(sampled(run, samples));
    for (const double s : runs_->front().motion->supports(
             runs_->front().loads.loads_at(runs_->front().loads.begin())))
      samples.held.push_back(si<Length>(s));
    std::sort(samples.held.begin(), samples.held.end());
    return samples;
  }

 private:
  double length() const { return project_->beam.length().value(); }

  bool slides() const {
    for (const std::vector<CutForceDiagram>& diagrams : looked_at_) {
      const std::vector<double> first = borders_of(diagrams.front());
      for (const CutForceDiagram& diagram : diagrams) {
        const std::vector<double> borders = borders_of(diagram);
        if (borders.size() != first.size()) return true;
        for (std::size_t i = 0; i < borders.size(); ++i)
          if (std::abs(borders[i] - first[i]) > 1e-9 * length()) return true;
      }
    }
    return false;
  }

  /// All places where something is, ascending, each once.
  std::vector<Length> places() const {
    const std::vector<Length> known = places_of(project_->beam);
    std::vector<Length> places = known;
    const auto add = [&](Length s) { places.push_back(place_near(known, s)); };
    for (const std::vector<CutForceDiagram>& diagrams : looked_at_)
      for (const double s : borders_of(diagrams.front())) add(si<Length>(s));
    for (const StationEnvelope& at : verification_->stations) add(at.station.s);
    for (const CheckResult& result : verification_->checks)
      if (result.check.on_beam) add(result.check.station.s);
    places.push_back(Length{});
    places.push_back(project_->beam.length());
    std::sort(places.begin(), places.end());
    const double close = 1e-10 * length();
    std::vector<Length> each;
    for (const Length& s : places) {
      if (!each.empty() && (s - each.back()).value() <= close) continue;
      if (s.value() < 0.0 || s > project_->beam.length()) continue;
      each.push_back(s);
    }
    each.back() = project_->beam.length();
    return each;
  }

  template <class Visit>
  void each_diagram(const Visit& visit) const {
    for (const std::vector<CutForceDiagram>& diagrams : looked_at_)
      for (const CutForceDiagram& diagram : diagrams) visit(diagram);
  }

  bool jumps_at(Length s) const {
    double most = 0.0;
    each_diagram([&](const CutForceDiagram& diagram) {
      const CutForces before = diagram.at({s, Side::before}),
                      behind = diagram.at({s, Side::behind});
      most = std::max(most, larger(scale_.of(before, behind)));
    });
    return most > 1e-12;
  }

  SamplingError chord_error(Length from, Length to) const {
    SamplingError error;
    each_diagram([&](const CutForceDiagram& diagram) {
      const CutForces a = diagram.at({from, Side::behind}), b = diagram.at({to, Side::before});
      for (const double part : quarters) {
        const CutForces at = diagram.at({from + part * (to - from), Side::both});
        take_larger(scale_.of(at, between(a, b, part)), error);
      }
    });
    return error;
  }

  void choose_stations(LoadSamples& samples) {
    const std::vector<Length> all = places();
    std::vector<Station>& stations = samples.stations;
    stations.push_back({Length{}, Side::behind});
    std::vector<int> wanted;
    for (std::size_t i = 1; i < all.size(); ++i)
      wanted.push_back(parts_for(larger(chord_error(all[i - 1], all[i]))));
    const int sum = std::accumulate(wanted.begin(), wanted.end(), 0);
    const double coarser = std::max(1.0, static_cast<double>(sum) / most_stations);
    for (std::size_t i = 1; i < all.size(); ++i) {
      const Length &from = all[i - 1], &to = all[i];
      const int parts = static_cast<int>(std::ceil(wanted[i - 1] / coarser));
      Length last = from;
      for (int k = 1; k <= parts; ++k) {
        const Length s = k == parts ? to : from + (to - from) * (static_cast<double>(k) / parts);
        take_larger(chord_error(last, s), samples.error);
        last = s;
        if (k < parts) stations.push_back({s, Side::both});
      }
      if (i + 1 == all.size()) {
        stations.push_back({to, Side::before});
      } else if (jumps_at(to)) {
        stations.push_back({to, Side::before});
        stations.push_back({to, Side::behind});
      } else {
        stations.push_back({to, Side::both});
      }
    }
  }

  static std::vector<CutForces> cuts_in(const CutForceDiagram& diagram,
                                        const std::vector<Station>& stations) {
    std::vector<CutForces> cuts;
    cuts.reserve(stations.size());
    for (const Station& station : stations) cuts.push_back(diagram.at(station));
    return cuts;
  }

  /// Instants of a run in which something that enters a check is extreme.
  std::vector<double> extremes_in(const SituationRun& run) const {
    std::vector<double> times;
    const std::size_t index = index_of(*project_, *run.situation);
    const auto add = [&](const Extreme& extreme) {
      if (extreme.situation == index) times.push_back(extreme.time.value());
    };
    for (const StationEnvelope& at : verification_->stations) {
      for (const Envelope& of : at.of) {
        add(of.smallest);
        add(of.largest);
      }
    }
    for (const CheckResult& result : verification_->checks) {
      if (!result.basis) continue;
      add(result.basis->highest);
      add(result.basis->lowest);
      if (result.basis->running == index) times.push_back(result.check.time.value());
    }
    for (const Criterion criterion : criteria) {
      const CheckResult* const governing = verification_->governing(criterion);
      if (governing == nullptr) continue;
      if (!governing->basis) {
        times.push_back(governing->check.time.value());
        continue;
      }
      const StressPoint& point = governing->basis->point;
      const StationHistory history(run.loads, point.station);
      for (const auto part : {&PointStress::normal, &PointStress::shear}) {
        for (const TurningPoint& turn : history.turning_points([&](const CutForces& cut) {
               return (stress_at(point.influence, cut).*part).value();
             }))
          times.push_back(turn.time.value());
      }
    }
    return times;
  }

  SampledSituation sampled(const SituationRun& run, LoadSamples& samples) const {
    const LoadHistory& loads = run.loads;
    const std::vector<Station>& stations = samples.stations;
    SampledSituation of;
    of.situation = index_of(*project_, *run.situation);
    struct Instant {
      double time;
      std::vector<CutForces> cuts;
      bool jumps = false;  ///< from the instant before it
    };
    std::vector<Instant> base;
    for (std::size_t i = 0; i < loads.instants(); ++i) {
      base.push_back({loads.time_of(i).value(), cuts_in(loads.diagram(i), stations),
                      i > 0 && !loads.is_recorded() && loads.begins_piece(i)});
    }
    const double begin = loads.begin().value(), period = loads.period().value();
    if (loads.closed() && !loads.begins_piece(0))
      base.push_back({begin + period, base.front().cuts, false});
    if (loads.is_recorded()) {
      for (Instant& instant : base) {
        of.times.push_back(instant.time);
        of.at.push_back(std::move(instant.cuts));
      }
      return of;
    }
    std::vector<double> extremes = extremes_in(run);
    for (double& time : extremes) {
      if (!loads.closed()) continue;
      while (time < begin) time += period;
      while (time > begin + period) time -= period;
    }
    std::sort(extremes.begin(), extremes.end());
    const double close = 1e-7 * period / static_cast<double>(base.size());
    const auto add = [&](double time, std::vector<CutForces> cuts) {
      of.times.push_back(time);
      of.at.push_back(std::move(cuts));
    };
    for (std::size_t i = 0; i < base.size(); ++i) {
      if (i > 0 && !base[i].jumps) fill(run, base[i - 1], base[i], extremes, close, samples, of);
      double time = base[i].time;
      // Instants closer than that are read as one: a jump would be lost.
      if (i > 0 && base[i].jumps) time = std::max(time, of.times.back() + close);
      add(time, std::move(base[i].cuts));
      base[i].cuts = of.at.back();
      if (i > 0) base[i - 1].cuts.clear();
    }
    return of;
  }

  /// Adds the instants between two of the loads.
  template <class Instant>
  void fill(const SituationRun& run, const Instant& from, const Instant& to,
            const std::vector<double>& extremes, double close, LoadSamples& samples,
            SampledSituation& of) const {
    const std::vector<Station>& stations = samples.stations;
    const double step = to.time - from.time;
    const auto cuts_at = [&](double time) {
      return cuts_in(run.loads.diagram_at(si<Time>(time)), stations);
    };
    double error = 0.0;
    for (const double part : quarters) {
      const std::vector<CutForces> at = cuts_at(from.time + part * step);
      for (std::size_t j = 0; j < stations.size(); ++j)
        error = std::max(error, larger(scale_.of(at[j], between(from.cuts[j], to.cuts[j], part))));
    }
    const auto most = static_cast<int>(most_instants / run.loads.instants());
    const int parts = std::min(parts_for(error), std::max(most, 1));
    std::vector<double> times;
    for (int k = 1; k < parts; ++k) times.push_back(from.time + step * k / parts);
    for (const double time : extremes)
      if (time > from.time + close && time < to.time - close) times.push_back(time);
    std::sort(times.begin(), times.end());
    std::vector<CutForces> before = from.cuts;
    double last = from.time;
    const auto measure = [&](double next, const std::vector<CutForces>& cuts) {
      const std::vector<CutForces> halfway = cuts_at(0.5 * (last + next));
      SamplingError largest;
      for (std::size_t j = 0; j < stations.size(); ++j)
        take_larger(scale_.of(halfway[j], between(before[j], cuts[j], 0.5)), largest);
      in_time_.force = std::max(in_time_.force, largest.force);
      in_time_.moment = std::max(in_time_.moment, largest.moment);
    };
    for (const double time : times) {
      if (time - last <= close) continue;
      std::vector<CutForces> cuts = cuts_at(time);
      measure(time, cuts);
      last = time;
      before = cuts;
      of.times.push_back(time);
      of.at.push_back(std::move(cuts));
    }
    measure(to.time, to.cuts);
  }

  const Project* project_;
  const std::deque<SituationRun>* runs_;
  const Verification* verification_;
  Scale scale_;
  std::deque<std::vector<CutForceDiagram>> looked_at_;  ///< of each run
  mutable SamplingError in_time_;

 public:
  const SamplingError& in_time() const { return in_time_; }
};

}  // namespace

LoadSamples sample_loads(const Project& project, const std::deque<SituationRun>& runs,
                         const Verification& verification) {
  Sampling sampling(project, runs, verification);
  LoadSamples samples = sampling.take();
  samples.error.force += sampling.in_time().force;
  samples.error.moment += sampling.in_time().moment;
  return samples;
}

}  // namespace boxbeam
