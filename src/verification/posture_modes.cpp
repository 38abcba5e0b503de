#include "boxbeam/verification/posture_modes.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "boxbeam/core/angle.hpp"
#include "boxbeam/mechanism/flexible/beam_loads.hpp"
#include "modal_motion.hpp"

namespace boxbeam {
namespace {

/// Places of the beam whose motion tells modes apart.
constexpr int samples = 9;

Eigen::VectorXd shape_of(const flexible::Structure& structure, int beam_link, double beam_mass,
                         const flexible::Deformation<double>& deformation) {
  const std::vector<flexible::Link>& links = structure.mechanism->links;
  std::vector<double> shape;
  const auto add_places = [&](int index, double mass) {
    const flexible::Link& link = links[static_cast<std::size_t>(index)];
    const double c = std::cos(link.angle);
    const double s = std::sin(link.angle);
    for (int k = 0; k < samples; ++k) {
      const flexible::Attachment place{index, {link.length * k / (samples - 1.0), 0.0}};
      const Eigen::Vector3d world = flexible::motion_at(structure, place, deformation);
      shape.push_back(std::sqrt(mass / samples) * (c * world.x() + s * world.y()));
      shape.push_back(std::sqrt(mass / samples) * (c * world.y() - s * world.x()));
    }
  };
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (static_cast<int>(i) == beam_link) continue;
    if (links[i].kind == flexible::LinkKind::full) {
      add_places(static_cast<int>(i), flexible::rigid_mass_of(links[i]).mass);
      continue;
    }
    const flexible::RigidMass& mass = links[i].rigid;
    const Eigen::Vector3d motion = deformation.motion[i].col(0);
    shape.push_back(motion[0] * std::sqrt(mass.mass));
    shape.push_back(motion[1] * std::sqrt(mass.mass));
    shape.push_back(motion[2] * std::sqrt(mass.inertia));
  }
  add_places(beam_link, beam_mass);
  return Eigen::Map<const Eigen::VectorXd>(shape.data(), static_cast<Eigen::Index>(shape.size()));
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

PostureModes::Strained strained(const flexible::Structure& structure,
                                const flexible::ModalModel& model, std::size_t link) {
  PostureModes::Strained of;
  of.link = structure.links[link];
  const auto size = static_cast<Eigen::Index>(model.modes.size());
  for (std::size_t i = 0; i < of.link.springs.size(); ++i) {
    Eigen::Matrix3Xd& strains = of.strains.emplace_back(3, size);
    for (Eigen::Index j = 0; j < size; ++j) {
      strains.col(j) =
          strain_of(of.link, i, model.modes[static_cast<std::size_t>(j)].shape.motion[link]);
    }
  }
  return of;
}

/// How far a joint gives way in each mode, by what it does.
Eigen::Matrix3Xd gaps_of(const flexible::ModalModel& model, std::size_t joint) {
  const std::array<double, 3>& stiffness = model.structure->mechanism->joints[joint].stiffness;
  Eigen::Matrix3Xd gaps(3, static_cast<Eigen::Index>(model.modes.size()));
  for (Eigen::Index j = 0; j < gaps.cols(); ++j) {
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double k = stiffness[static_cast<std::size_t>(axis)];
      const flexible::Deformation<double>& shape = model.modes[static_cast<std::size_t>(j)].shape;
      gaps(axis, j) = k > 0.0 ? shape.joints(axis, static_cast<Eigen::Index>(joint)) / k : 0.0;
    }
  }
  return gaps;
}

std::size_t free_motions_of(const flexible::ModalModel& model) {
  return static_cast<std::size_t>(
      std::count_if(model.modes.begin(), model.modes.end(),
                    [](const flexible::Mode& of) { return of.frequency == 0.0; }));
}

/// A motion of a link across and about it, of all modes: at one of its nodes.
struct NodeMotion {
  Eigen::RowVectorXd across, turn;
};

NodeMotion motion_of_node(const PostureModes& modes, std::size_t link, std::size_t node) {
  const auto size = static_cast<Eigen::Index>(modes.motions.size());
  NodeMotion of{Eigen::RowVectorXd(size), Eigen::RowVectorXd(size)};
  for (Eigen::Index j = 0; j < size; ++j) {
    const Eigen::Matrix3Xd& motion = modes.motions[static_cast<std::size_t>(j)].shape.motion[link];
    of.across[j] = motion(1, static_cast<Eigen::Index>(node));
    of.turn[j] = motion(2, static_cast<Eigen::Index>(node));
  }
  return of;
}

/// What bending and shear of a part bear between modes, by its flexibilities and its levers.
Eigen::MatrixXd bent_part(const flexible::DividedLink& link, std::size_t part,
                          const NodeMotion& from, const NodeMotion& to) {
  const flexible::SpringElement& of = link.springs[part];
  const double from_start = of.reach * (of.place - link.elements[part].node),
               from_end = of.reach * (of.place - link.elements[part + 1].node);
  Eigen::Matrix2Xd gaps(2, from.turn.size());
  gaps.row(0) = to.across + from_end * to.turn - from.across - from_start * from.turn;
  gaps.row(1) = to.turn - from.turn;
  return gaps.transpose() * of.bending.inverse() * gaps;
}

/// How a joint opens across its line in all modes.
Eigen::RowVectorXd gaps_across(const PostureModes& modes, const flexible::Structure::Ends& ends) {
  Eigen::RowVectorXd gaps =
      Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(modes.motions.size()));
  for (const auto& [grip, sign] : {std::pair(&ends.a, -1.0), std::pair(&ends.b, 1.0)}) {
    if (grip->link == flexible::ground) continue;
    const Eigen::RowVector3d across = sign * ends.axes.row(1) * grip->motion;
    for (Eigen::Index j = 0; j < gaps.size(); ++j) {
      const auto& motion = modes.motions[static_cast<std::size_t>(j)].shape.motion;
      gaps[j] += across.dot(motion[static_cast<std::size_t>(grip->link)].col(
          static_cast<Eigen::Index>(grip->element)));
    }
  }
  return gaps;
}

bool is_damped_joint(const flexible::Joint& joint) {
  return std::any_of(joint.damping.begin(), joint.damping.end(),
                     [](double of) { return of != 0.0; });
}

PostureModes described_modes(const LoadedPosture& posture, flexible::ModalModel model) {
  const flexible::Structure& structure = posture.structure;
  const auto beam_index = static_cast<std::size_t>(posture.beam_link);
  const flexible::Link& beam = posture.links->links[beam_index];
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
  modes.beam = strained(structure, model, beam_index);
  for (const auto& [link, rigid] : posture.beside)
    modes.beside.push_back(strained(structure, model, static_cast<std::size_t>(link)));
  for (const auto& [joint, rigid] : posture.joints) modes.gaps.push_back(gaps_of(model, joint));
  // What moves without force is not strained, but by round-off.
  const auto free = static_cast<Eigen::Index>(free_motions_of(model));
  const auto unstrain = [&](PostureModes::Strained& of) {
    for (Eigen::Matrix3Xd& strains : of.strains) strains.leftCols(free).setZero();
  };
  unstrain(modes.beam);
  for (PostureModes::Strained& of : modes.beside) unstrain(of);
  modes.motions = std::move(model.modes);
  return modes;
}

}  // namespace

PostureModes modes_in_posture(const LoadedPosture& posture, std::size_t count, std::size_t may) {
  flexible::ModalModel model = flexible::modal_model_of(posture.structure, count);
  if (may > 0 && free_motions_of(model) > may)
    refuse_vibration(
        "the mechanism is free to move by more than what forces move, or without mass");
  return described_modes(posture, std::move(model));
}

PostureModes straining_modes_in(const LoadedPosture& posture, std::size_t count, std::size_t may) {
  flexible::ModalModel model = flexible::modal_model_of(posture.structure, count + may);
  const std::size_t free = std::min(free_motions_of(model), may);
  model.modes.erase(model.modes.begin(), model.modes.begin() + static_cast<std::ptrdiff_t>(free));
  model.modes.resize(std::min(count, model.modes.size()));
  const auto first = static_cast<Eigen::Index>(free),
             size = static_cast<Eigen::Index>(model.modes.size());
  model.damping = model.damping.block(first, first, size, size).eval();
  return described_modes(posture, std::move(model));
}

std::vector<JointDamper> dampers_in(const LoadedPosture& posture, const PostureModes& modes) {
  const std::vector<flexible::Joint>& joints = posture.links->joints;
  if (std::none_of(joints.begin(), joints.end(), is_damped_joint)) return {};
  std::vector<JointDamper> all;
  for (const flexible::DampedWay& way :
       flexible::damped_ways_of({&posture.structure, modes.motions, {}})) {
    JointDamper& of = all.emplace_back();
    of.damping = way.damping;
    of.gaps = way.gaps;
    of.loads = loads_in_motion(posture, way.pulled, 0.0);
    // The work of f on a mode is -gap: that part of it the inertia of the mode bears.
    flexible::Deformation<double> moving = way.pulled;
    for (Eigen::Matrix3Xd& link : moving.motion) link.setZero();
    moving.joints.setZero();
    for (std::size_t j = 0; j < modes.motions.size(); ++j) {
      const double gap = way.gaps[static_cast<Eigen::Index>(j)];
      const double omega = full_turn * modes.frequencies[j];
      if (omega > 0.0) {
        add(of.loads, gap / (omega * omega), modes.loads[j]);
        continue;
      }
      for (std::size_t k = 0; k < moving.motion.size(); ++k)
        moving.motion[k] += gap * modes.motions[j].shape.motion[k];
    }
    constexpr double unit = 1.0 / full_turn;  // inertia of these accelerations
    if (modes.frequencies.front() == 0.0)
      add(of.loads, 1.0, loads_in_motion(posture, moving, unit));
  }
  return all;
}

Eigen::MatrixXd damping_of_material(const PostureModes& modes,
                                    const std::vector<JointDamper>& dampers) {
  Eigen::MatrixXd damping = modes.damping;
  for (const JointDamper& of : dampers) damping -= of.damping * of.gaps * of.gaps.transpose();
  return damping;
}

Eigen::MatrixXd geometric_stiffness_of(const PostureModes& modes, const LoadedPosture& straight,
                                       const LoadedPosture& pressed) {
  const auto size = static_cast<Eigen::Index>(modes.motions.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < straight.structure.links.size(); ++k) {
    const flexible::DividedLink &before = straight.structure.links[k],
                                &behind = pressed.structure.links[k];
    NodeMotion last;
    for (std::size_t i = 0; i < before.elements.size(); ++i) {
      NodeMotion node = motion_of_node(modes, k, i);
      sum += (behind.elements[i].turning - before.elements[i].turning) * node.turn.transpose() *
             node.turn;
      if (i > 0 && !before.springs[i - 1].bending.isZero(0.0))
        sum += bent_part(behind, i - 1, last, node) - bent_part(before, i - 1, last, node);
      last = std::move(node);
    }
  }
  for (std::size_t j = 0; j < straight.links->joints.size(); ++j) {
    const double across =
        pressed.links->joints[j].stiffness[1] - straight.links->joints[j].stiffness[1];
    // Of what is rigid there is no difference.
    if (!(std::abs(across) > 0.0)) continue;
    const Eigen::RowVectorXd gaps = gaps_across(modes, straight.structure.joints[j]);
    sum += across * gaps.transpose() * gaps;
  }
  return sum;
}

Eigen::MatrixXd masses_between(const LoadedPosture& posture, const PostureModes& modes,
                               const PostureModes& others) {
  const auto size = static_cast<Eigen::Index>(modes.motions.size()),
             count = static_cast<Eigen::Index>(others.motions.size());
  Eigen::MatrixXd masses = Eigen::MatrixXd::Zero(size, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const flexible::LinkColumns<double>& moved =
        others.motions[static_cast<std::size_t>(j)].shape.motion;
    for (std::size_t k = 0; k < moved.size(); ++k)
      if (moved[k].cols() != static_cast<Eigen::Index>(posture.structure.links[k].elements.size()))
        refuse_vibration(
            "where a spring begins or ends to act, what slides along a beam passes a place of it "
            "that is held; use --model rigid to have the loads of rigid bodies");
    const flexible::LinkColumns<double> inertia = flexible::mass_times(posture.structure, moved);
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto& motion = modes.motions[static_cast<std::size_t>(i)].shape.motion;
      for (std::size_t k = 0; k < inertia.size(); ++k)
        masses(i, j) += motion[k].cwiseProduct(inertia[k]).sum();
    }
  }
  return masses;
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

Eigen::VectorXd modal_loads(const PostureModes::Strained& of, const Eigen::Matrix3Xd& means) {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(of.strains.empty() ? 0 : of.strains.front().cols());
  for (std::size_t i = 0; i < of.strains.size(); ++i)
    p.noalias() += of.strains[i].transpose() * means.col(static_cast<Eigen::Index>(i));
  return p;
}

Eigen::VectorXd modal_loads(const PostureModes& modes, const LoadedPosture& posture) {
  Eigen::VectorXd p = modal_loads(modes.beam, means_over(posture.rigid, modes.beam.link.springs));
  for (std::size_t k = 0; k < modes.beside.size(); ++k) {
    const PostureModes::Strained& of = modes.beside[k];
    p += modal_loads(of, means_over(posture.beside[k].second, of.link.springs));
  }
  for (std::size_t k = 0; k < modes.gaps.size(); ++k)
    p += modes.gaps[k].transpose() * posture.joints[k].second;
  return p;
}

}  // namespace boxbeam
