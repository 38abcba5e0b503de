#include "boxbeam/verification/posture_modes.hpp"

#include <cmath>

#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam {
namespace {

/// Places of the beam whose motion tells modes apart.
constexpr int samples = 9;

Eigen::VectorXd shape_of(const flexible::Structure& structure, const ElasticBody& elastic,
                         double beam_mass, const flexible::Deformation<double>& deformation) {
  const std::vector<flexible::Link>& links = structure.mechanism->links;
  Eigen::VectorXd shape(3 * static_cast<Eigen::Index>(links.size() + samples));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (static_cast<int>(i) == elastic.body) continue;
    const flexible::RigidMass& mass = links[i].rigid;
    shape.segment<3>(at) = deformation.motion[i].col(0);
    shape.segment<2>(at) *= std::sqrt(mass.mass);
    shape[at + 2] *= std::sqrt(mass.inertia);
    at += 3;
  }
  const flexible::Link& beam = links[static_cast<std::size_t>(elastic.body)];
  const double c = std::cos(beam.angle);
  const double s = std::sin(beam.angle);
  for (int k = 0; k < samples; ++k) {
    const flexible::Attachment place{elastic.body, {elastic.length * k / (samples - 1.0), 0.0}};
    const Eigen::Vector3d world = flexible::motion_at(structure, place, deformation);
    shape[at++] = std::sqrt(beam_mass / samples) * (c * world.x() + s * world.y());
    shape[at++] = std::sqrt(beam_mass / samples) * (c * world.y() - s * world.x());
  }
  return shape.head(at);
}

/// The loads on the beam in a free vibration of size one: those of a response that is this mode.
BeamLoads loads_of_mode(const flexible::Structure& structure, int link, const TaperedBeam& beam,
                        const flexible::Mode& mode) {
  flexible::Response response;
  response.frequency = mode.frequency;
  response.constant = mode.shape;
  for (auto& motion : response.constant.motion) motion.setZero();
  response.constant.joints.setZero();
  for (const auto& motion : mode.shape.motion) {
    response.harmonic.motion.emplace_back(motion.cast<flexible::Complex>());
  }
  response.harmonic.joints = mode.shape.joints.cast<flexible::Complex>();
  return flexible::beam_response_of(structure, link, beam, response, response.harmonic.motion).sine;
}

/// N, V and couple of a diagram in the axes of a link: y of the beam points into the plane.
Eigen::Vector3d in_link_axes(const CutForces& cut) {
  return {cut.N.value(), cut.V_z.value(), -cut.M_y.value()};
}

/// The mean over a part, for cut forces that are polynomials of third degree in it.
Eigen::Vector3d mean_over(const CutForceDiagram& diagram, const flexible::SpringElement& part) {
  const auto at = [&](double s, Side side) {
    return in_link_axes(diagram.at({si<Length>(s), side}));
  };
  return (at(part.from, Side::behind) + 4.0 * at(0.5 * (part.from + part.to), Side::both) +
          at(part.to, Side::before)) /
         6.0;
}

}  // namespace

PostureModes modes_in_posture(const planar::Mechanism& mechanism, const planar::State& state,
                              const ElasticBody& elastic, const TaperedBeam& beam,
                              std::size_t count) {
  const flexible::Mechanism links = links_of(mechanism, state, elastic);
  const flexible::Structure structure = flexible::structure_of(links);
  const flexible::ModalModel model = flexible::modal_model_of(structure, count);
  const double mass =
      flexible::rigid_mass_of(links.links[static_cast<std::size_t>(elastic.body)]).mass;
  PostureModes modes;
  modes.damping = model.damping;
  for (const flexible::Mode& mode : model.modes) {
    const Eigen::VectorXd shape = shape_of(structure, elastic, mass, mode.shape);
    modes.shapes.conservativeResize(shape.size(), modes.shapes.cols() + 1);
    modes.shapes.rightCols<1>() = shape;
    modes.frequencies.push_back(mode.frequency);
    modes.loads.push_back(loads_of_mode(structure, elastic.body, beam, mode));
    modes.diagrams.push_back(cut_forces_of(modes.loads.back()));
  }
  modes.beam = structure.links[static_cast<std::size_t>(elastic.body)];
  return modes;
}

Eigen::VectorXd modal_loads(const PostureModes& modes, const CutForceDiagram& rigid) {
  const auto count = static_cast<Eigen::Index>(modes.diagrams.size());
  Eigen::VectorXd p = Eigen::VectorXd::Zero(count);
  for (const flexible::SpringElement& part : modes.beam.springs) {
    Eigen::Vector3d strain = mean_over(rigid, part);
    strain[0] *= part.axial;
    strain.tail<2>() = part.bending * strain.tail<2>().eval();
    for (Eigen::Index j = 0; j < count; ++j) {
      p[j] += strain.dot(mean_over(modes.diagrams[static_cast<std::size_t>(j)], part));
    }
  }
  return p;
}

}  // namespace boxbeam
