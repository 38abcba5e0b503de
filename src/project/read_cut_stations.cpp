#include "read_cut_stations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace boxbeam::readers {
namespace {

using recorded::SixForces;

constexpr SixColumns cut_columns{
    {"N", "V_y", "V_z", "T", "M_y", "M_z"},
    {"column of the normal force, tension positive", "column of the shear force V_y, in space",
     "column of the shear force V_z", "column of the torque, in space",
     "column of the bending moment M_y", "column of the bending moment M_z, in space"}};

/// The given cut force of a station at an instant.
double given_at(const std::vector<Term>& terms, const recorded::Channels& channels,
                std::size_t station, std::size_t k, std::size_t instant) {
  double sum = 0.0;
  for (const Term& term : terms) {
    if (term.place != station) continue;
    const double part = (k < 3 ? term.force : term.moment)[static_cast<Eigen::Index>(k % 3)];
    if (part != 0.0) sum += part * channels.values[*term.channel][instant];
  }
  return sum;
}

/// Where V is farthest from dM_y/ds or -dM_z/ds, of the largest of them.
void find_shear_defect(const std::vector<double>& stations, const std::vector<Term>& terms,
                       const recorded::Channels& channels, recorded::Loads& loads) {
  for (const auto& [shear, moment, sign] : {std::tuple{2, 4, 1.0}, {1, 5, -1.0}}) {
    const auto V = static_cast<std::size_t>(shear), M = static_cast<std::size_t>(moment);
    double largest = 0.0, worst = 0.0;
    std::size_t station = 0, when = 0;
    for (std::size_t j = 0; j + 1 < stations.size(); ++j) {
      const double h = stations[j + 1] - stations[j];
      if (h == 0.0) continue;  // a jump
      for (std::size_t i = 0; i < channels.times.size(); ++i) {
        const double a = given_at(terms, channels, j, V, i),
                     b = given_at(terms, channels, j + 1, V, i);
        const double slope =
            sign * (given_at(terms, channels, j + 1, M, i) - given_at(terms, channels, j, M, i)) /
            h;
        largest = std::max({largest, std::abs(a), std::abs(b), std::abs(slope)});
        const double apart = std::abs(0.5 * (a + b) - slope);
        if (apart <= worst) continue;
        worst = apart;
        station = j;
        when = i;
      }
    }
    if (largest == 0.0 || worst / largest <= loads.shear_defect) continue;
    loads.shear_defect = worst / largest;
    loads.shear_defect_at =
        fmt::format("{} between s = {:.6g} and {:.6g} m at t = {:.6g} s", cut_columns.words[V],
                    stations[station], stations[station + 1], channels.times[when]);
  }
}

}  // namespace

void CutStations::read(TableReader& root, const TaperedBeam& beam, ChannelFiles& files,
                       RecordedTerms& into) {
  for (TableReader& table :
       root.tables({"cut_forces",
                    "at stations along the beam, linear between them; one that stands twice "
                    "has those before and behind a jump"})) {
    const double s = station_of(table, {"station", "station"}, beam).value();
    const bool twice = !stations_.empty() && s == stations_.back();
    const bool thrice = twice && stations_.size() > 1 && s == stations_[stations_.size() - 2];
    if (!stations_.empty() && (thrice || !(s >= stations_.back()))) {
      table.problem("station", "the stations of cut forces ascend along the beam",
                    "write them in order, each once, or twice where the cut forces jump: before "
                    "it and behind");
    }
    stations_.push_back(s);
    given_.emplace_back();
    if (!table.has("columns")) {  // a free end
      table.finish();
      continue;
    }
    const std::optional<std::size_t> file = files.file_of(table);
    const double factor = read_factor(table);
    TableReader columns =
        table.table({"columns", "of the file, by what they are; none at a free end"});
    if (!file) {
      columns.accept_all();
      table.finish();
      continue;
    }
    given_.back() =
        read_six(columns, cut_columns, *file, factor, stations_.size() - 1, files, into);
    columns.finish();
    table.finish();
  }
  check(root, beam);
}

void CutStations::check(TableReader& root, const TaperedBeam& beam) {
  if (!root.problems().empty()) return;
  const double length = beam.length().value();
  const bool ends = stations_.size() >= 2 && stations_.front() <= 1e-9 * length &&
                    stations_.back() >= (1.0 - 1e-9) * length;
  if (!ends) {
    root.problem("cut_forces",
                 stations_.empty()
                     ? "no station has cut forces"
                     : fmt::format("cut forces are given from s = {:.6g} to {:.6g} m, and the "
                                   "beam goes from 0 to {:.6g} m",
                                   stations_.front(), stations_.back(), length),
                 "give a station at both ends of the beam; one without columns is a free end");
    return;
  }
  if (stations_[1] == stations_.front() || stations_[stations_.size() - 2] == stations_.back()) {
    root.problem("cut_forces", "an end of the beam stands twice in the stations",
                 "give what is cut just within the beam; outside it nothing is cut");
    return;
  }
  stations_.front() = 0.0;
  stations_.back() = length;
  std::array<bool, 6> ever{};
  for (const std::array<bool, 6>& at : given_) {
    for (std::size_t k = 0; k < 6; ++k) ever[k] = ever[k] || at[k];
  }
  for (std::size_t j = 0; j < given_.size(); ++j) {
    const bool free_end =
        std::none_of(given_[j].begin(), given_[j].end(), [](bool is) { return is; });
    for (std::size_t k = 0; k < 6 && !free_end; ++k) {
      if (!ever[k] || given_[j][k]) continue;
      root.problem("cut_forces",
                   fmt::format("{} is given at other stations and not at s = {:.6g} m",
                               cut_columns.words[k], stations_[j]),
                   "name its column, or leave out all columns where the beam is free");
    }
  }
  for (const auto& [moment, shear] : {std::pair{4, 2}, {5, 1}}) {
    const auto M = static_cast<std::size_t>(moment), V = static_cast<std::size_t>(shear);
    if (ever[M] == ever[V]) continue;
    root.problem("cut_forces",
                 ever[M]
                     ? fmt::format("{} is given without {}: its shear stresses would be missing",
                                   cut_columns.words[M], cut_columns.words[V])
                     : fmt::format("{} is given without {}, which changes along the beam by it",
                                   cut_columns.words[V], cut_columns.words[M]),
                 ever[M] ? "name the column of the shear force as well"
                         : "name the column of the bending moment as well");
  }
}

void CutStations::put_together(const TaperedBeam& beam, const std::vector<Term>& terms,
                               const recorded::Channels& channels, recorded::Loads& loads) const {
  const std::vector<SixForces> none(stations_.size(), SixForces{});
  recorded::ChannelLoads& acting = loads.acting;
  acting.constant = recorded::loads_of_cuts(beam, stations_, none);
  for (std::size_t k = 0; k < channels.values.size(); ++k) {
    std::vector<SixForces> unit = none;
    for (const Term& term : terms) {
      if (term.channel != k) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        unit[term.place][c] += term.force[static_cast<Eigen::Index>(c)];
        unit[term.place][c + 3] += term.moment[static_cast<Eigen::Index>(c)];
      }
    }
    acting.units.push_back(recorded::loads_of_cuts(beam, stations_, unit));
  }
  find_shear_defect(stations_, terms, channels, loads);
}

}  // namespace boxbeam::readers
