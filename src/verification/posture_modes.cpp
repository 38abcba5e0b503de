#include "boxbeam/verification/posture_modes.hpp"

#include <cmath>

#include "boxbeam/mechanism/flexible/modal_response.hpp"

namespace boxbeam {
namespace {

/// Places of the beam whose motion tells modes apart.
constexpr int samples = 9;

Eigen::VectorXd shape_of(const flexible::Structure& structure, int beam_link, double beam_mass,
                         const flexible::Deformation<double>& deformation) {
  const std::vector<flexible::Link>& links = structure.mechanism->links;
  Eigen::VectorXd shape(3 * static_cast<Eigen::Index>(links.size() + samples));
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (static_cast<int>(i) == beam_link) continue;
    const flexible::RigidMass& mass = links[i].rigid;
    shape.segment<3>(at) = deformation.motion[i].col(0);
    shape.segment<2>(at) *= std::sqrt(mass.mass);
    shape[at + 2] *= std::sqrt(mass.inertia);
    at += 3;
  }
  const flexible::Link& beam = links[static_cast<std::size_t>(beam_link)];
  const double c = std::cos(beam.angle);
  const double s = std::sin(beam.angle);
  for (int k = 0; k < samples; ++k) {
    const flexible::Attachment place{beam_link, {beam.length * k / (samples - 1.0), 0.0}};
    const Eigen::Vector3d world = flexible::motion_at(structure, place, deformation);
    shape[at++] = std::sqrt(beam_mass / samples) * (c * world.x() + s * world.y());
    shape[at++] = std::sqrt(beam_mass / samples) * (c * world.y() - s * world.x());
  }
  return shape.head(at);
}

/// d_i . d_j and d_i x d_j over the masses of a link in two modes.
void add_products(const flexible::DividedLink& link, const Eigen::Matrix3Xd& of_i,
                  const Eigen::Matrix3Xd& of_j, double& dot, double& cross) {
  for (std::size_t k = 0; k < link.elements.size(); ++k) {
    const flexible::RigidElement& element = link.elements[k];
    if (element.mass <= 0.0) continue;
    const auto column = static_cast<Eigen::Index>(k);
    const Eigen::Vector2d arm = element.first_moment / element.mass;
    const auto shift = [&](const Eigen::Matrix3Xd& motion) -> Eigen::Vector2d {
      const Eigen::Vector3d at = motion.col(column);
      return {at[0] - at[2] * arm.y(), at[1] + at[2] * arm.x()};
    };
    const Eigen::Vector2d i = shift(of_i);
    const Eigen::Vector2d j = shift(of_j);
    dot += element.mass * i.dot(j);
    // i . (e_z x j): what turns j to its left.
    cross += element.mass * (i.y() * j.x() - i.x() * j.y());
  }
}

/// How a part of a link is stretched, shifted across and turned in a motion.
Eigen::Vector3d strain_of(const flexible::DividedLink& link, std::size_t part,
                          const Eigen::Matrix3Xd& motion) {
  const auto column = static_cast<Eigen::Index>(part);
  const double place = link.springs[part].place;
  const Eigen::Vector3d from = motion.col(column);
  const Eigen::Vector3d to = motion.col(column + 1);
  return {to[0] - from[0],
          to[1] - (link.springs[part].to - place) * to[2] - from[1] -
              (place - link.springs[part].from) * from[2],
          to[2] - from[2]};
}

}  // namespace

PostureModes modes_in_posture(const LoadedPosture& posture, std::size_t count) {
  const flexible::Structure& structure = posture.structure;
  const auto beam_index = static_cast<std::size_t>(posture.beam_link);
  const flexible::Link& beam = posture.links->links[beam_index];
  const flexible::ModalModel model = flexible::modal_model_of(structure, count);
  const double mass = flexible::rigid_mass_of(beam).mass;
  PostureModes modes;
  modes.damping = model.damping;
  for (const flexible::Mode& mode : model.modes) {
    const Eigen::VectorXd shape = shape_of(structure, posture.beam_link, mass, mode.shape);
    modes.shapes.conservativeResize(shape.size(), modes.shapes.cols() + 1);
    modes.shapes.rightCols<1>() = shape;
    modes.frequencies.push_back(mode.frequency);
    modes.loads.push_back(loads_in_motion(posture, mode.shape, mode.frequency));
    modes.diagrams.push_back(cut_forces_of(modes.loads.back()));
  }
  const auto size = static_cast<Eigen::Index>(model.modes.size());
  for (std::size_t body = 0; body < structure.links.size(); ++body) {
    Eigen::MatrixXd& shifting = modes.shifting.emplace_back(Eigen::MatrixXd::Zero(size, size));
    Eigen::MatrixXd& turning = modes.turning.emplace_back(Eigen::MatrixXd::Zero(size, size));
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index j = 0; j < size; ++j) {
        add_products(structure.links[body],
                     model.modes[static_cast<std::size_t>(i)].shape.motion[body],
                     model.modes[static_cast<std::size_t>(j)].shape.motion[body], shifting(i, j),
                     turning(i, j));
      }
    }
  }
  modes.beam = structure.links[beam_index];
  for (std::size_t i = 0; i < modes.beam.springs.size(); ++i) {
    Eigen::Matrix3Xd& strains = modes.strains.emplace_back(3, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      strains.col(j) = strain_of(modes.beam, i,
                                 model.modes[static_cast<std::size_t>(j)].shape.motion[beam_index]);
    }
  }
  return modes;
}

FrameTerms frame_terms(const PostureModes& modes, const planar::State& state) {
  const auto size = static_cast<Eigen::Index>(modes.frequencies.size());
  FrameTerms terms{Eigen::MatrixXd::Zero(size, size), Eigen::MatrixXd::Zero(size, size)};
  // Behind the bodies come toothed wheels without mass.
  const auto bodies = static_cast<std::size_t>(state.v.size() / 3);
  for (std::size_t body = 0; body < bodies; ++body) {
    const Eigen::Index angle = 3 * static_cast<Eigen::Index>(body) + 2;
    const double omega = state.v[angle];
    terms.of_rate += 2.0 * omega * modes.turning[body];
    terms.of_size += state.a[angle] * modes.turning[body] - omega * omega * modes.shifting[body];
  }
  return terms;
}

Eigen::Matrix3Xd means_over(const CutForceDiagram& diagram,
                            const std::vector<flexible::SpringElement>& springs) {
  Eigen::Matrix3Xd means(3, static_cast<Eigen::Index>(springs.size()));
  Eigen::Index i = 0;
  for (const flexible::SpringElement& spring : springs) means.col(i++) = mean_over(diagram, spring);
  return means;
}

Eigen::VectorXd modal_loads(const PostureModes& modes, const Eigen::Matrix3Xd& means) {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(modes.diagrams.size()));
  for (std::size_t i = 0; i < modes.strains.size(); ++i)
    p.noalias() += modes.strains[i].transpose() * means.col(static_cast<Eigen::Index>(i));
  return p;
}

Eigen::VectorXd modal_loads(const PostureModes& modes, const CutForceDiagram& rigid) {
  return modal_loads(modes, means_over(rigid, modes.beam.springs));
}

}  // namespace boxbeam
