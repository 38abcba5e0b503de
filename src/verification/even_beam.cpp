#include "even_beam.hpp"

#include <Eigen/Geometry>

#include "boxbeam/section/section_properties.hpp"

namespace boxbeam {

void EvenBeam::set(const spatial::Mechanism& mechanism, const spatial::State& open, int of,
                   const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Section& section) {
  const Eigen::Vector3d line = to - from;
  const double length = line.norm();
  const double mass = mechanism.bodies[static_cast<std::size_t>(of)].mass;
  beam.segments = {{"", {}, si<Length>(length), section, section}};
  beam.density = si<Density>(mass / (properties_of(section).area.value() * length));
  spatial::BeamPlacement placement{of, from, {}};
  placement.axes.col(0) = line / length;
  placement.axes.col(1) = placement.axes.col(0).unitOrthogonal();
  placement.axes.col(2) = placement.axes.col(0).cross(placement.axes.col(1));
  body = spatial::beam_body_of(beam, placement, mechanism, open);
}

}  // namespace boxbeam
