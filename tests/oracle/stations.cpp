#include "stations.hpp"

#include <algorithm>

namespace oracle {

using namespace boxbeam;

namespace {

/// Whether loads slide along the beam, so that both sides of any station may differ.
bool sliding(const std::vector<Run>& sampled) {
  for (const Run& run : sampled) {
    const CutForceDiagram& first = run.diagrams.front();
    const CutForceDiagram& other = run.diagrams[run.diagrams.size() / 3];
    if (first.pieces.size() != other.pieces.size()) return true;
    for (std::size_t i = 0; i < first.pieces.size(); ++i) {
      if (abs(first.pieces[i].end() - other.pieces[i].end()).value() > 1e-12) return true;
    }
  }
  return false;
}

}  // namespace

std::set<double> cut_places_of(const Project& project, const std::vector<Run>& sampled,
                               const std::vector<BendingZone>& zones) {
  const TaperedBeam& beam = project.beam;
  std::set<double> places{0.0, beam.length().value()};
  for (const Segment& segment : beam.segments) {
    places.insert(segment.start.value());
    places.insert(segment.end().value());
  }
  for (const BeamHole& hole : project.holes) {
    const double radius = 0.5 * hole.hole.diameter.value();
    for (const double s : {hole.s.value() - radius, hole.s.value(), hole.s.value() + radius})
      if (s >= 0.0 && s <= beam.length().value()) places.insert(s);
  }
  for (const Diaphragm& diaphragm : beam.diaphragms) places.insert(diaphragm.s.value());
  for (const BeamDetail& detail : project.fatigue.details) {
    places.insert(detail.from.value());
    places.insert(detail.to.value());
  }
  for (const BendingZone& zone : zones) {
    places.insert(zone.from.value());
    places.insert(zone.to.value());
  }
  // Loads that slide are met at a few of their places.
  for (const Run& run : sampled) {
    const std::size_t stride = std::max<std::size_t>(1, run.diagrams.size() / 16);
    for (std::size_t i = 0; i < run.diagrams.size(); i += stride) {
      for (const CutForcePiece& piece : run.diagrams[i].pieces) {
        places.insert(std::clamp(piece.start.value(), 0.0, beam.length().value()));
        places.insert(std::clamp(piece.end().value(), 0.0, beam.length().value()));
      }
    }
  }
  return places;
}

std::vector<Station> stations_of(const Project& project, const std::vector<Run>& sampled,
                                 const std::vector<BendingZone>& zones, const Density& density) {
  const double length = project.beam.length().value();
  std::vector<Station> stations;
  const bool slides = sliding(sampled);
  for (const double s : cut_places_of(project, sampled, zones)) {
    if (s > 0.0) stations.push_back({si<Length>(s), Side::before});
    if (s < length) stations.push_back({si<Length>(s), Side::behind});
  }
  std::vector<bool> done(static_cast<std::size_t>(density.stations) + 1, false);
  for (int stride = 64; stride >= 1; stride /= 2) {
    for (int j = stride; j < density.stations; j += stride) {
      if (done[static_cast<std::size_t>(j)]) continue;
      done[static_cast<std::size_t>(j)] = true;
      const Length s = si<Length>(length * j / density.stations);
      stations.push_back({s, Side::before});
      if (!slides) continue;
      stations.push_back({s, Side::behind});
    }
  }
  return stations;
}

}  // namespace oracle
