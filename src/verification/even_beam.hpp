#pragma once

#include "boxbeam/beam/tapered_beam.hpp"
#include "boxbeam/mechanism/spatial/beam_loads.hpp"

namespace boxbeam {

/// A body in space as an even beam of its mass between two of its places. Not copied: the body
/// looks at the beam.
struct EvenBeam {
  EvenBeam() = default;
  EvenBeam(const EvenBeam&) = delete;
  EvenBeam& operator=(const EvenBeam&) = delete;

  /// `from`, `to`: axes of the body [m], apart from each other; `open`: `open_state_of` the
  /// mechanism.
  void set(const spatial::Mechanism& mechanism, const spatial::State& open, int of,
           const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Section& section);

  TaperedBeam beam;
  spatial::BeamBody body;
};

}  // namespace boxbeam
