#pragma once

#include <optional>
#include <string>
#include <vector>

#include "boxbeam/verification/checks.hpp"
#include "boxbeam/verification/cut_force_envelope.hpp"

namespace boxbeam {

/// A level at which the user looks: the first moment beyond it and the material it cuts, gross, for
/// V S/(I b).
struct LevelProperties {
  std::string name;
  Length z;
  SectionModulus first_moment;
  Length width;
};

/// The section at a verified station.
struct StationProperties {
  Station station;
  SectionProperties gross;
  SectionProperties net;  ///< without the holes there
  ForcePerLength weight;
  std::optional<ShearLag> shear_lag;    ///< of the flanges, where it counts
  std::vector<LevelProperties> levels;  ///< of the case's points here
};

/// The sections at the stations of a verification, as its checks found them.
std::vector<StationProperties> station_properties_of(const Project& project,
                                                     const std::vector<StationEnvelope>& stations,
                                                     const std::vector<CheckResult>& checks);

/// The piece of the beam between two of its named places.
struct BeamPart {
  std::string from, to;
  Length start, end;
  MassProperties mass;
};

/// The pieces between neighbouring named places; of several names for one place the first counts.
std::vector<BeamPart> parts_of(const TaperedBeam& beam);

/// How far the flanges of a tapered segment are inclined to the axis.
struct TaperSlope {
  std::string segment;
  double angle = 0.0;  ///< [rad]
};

std::vector<TaperSlope> taper_slopes_of(const TaperedBeam& beam);

/// The published concentration formula, evaluated for a hole that uses it.
struct PublishedConcentration {
  std::string hole;
  double diameter_to_width = 0.0;
  double factor = 0.0;
};

std::vector<PublishedConcentration> published_concentrations_of(const Project& project);

}  // namespace boxbeam
