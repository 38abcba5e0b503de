#include "boxbeam/mechanism/flexible/link_stiffness.hpp"

#include <cmath>
#include <type_traits>

#include "boxbeam/core/error.hpp"
#include "boxbeam/mechanism/flexible/response.hpp"
#include "element_mass.hpp"
#include "exact_part.hpp"

namespace boxbeam::flexible {
namespace {

/// A structure of so many elements is no longer solved.
constexpr std::size_t most_elements = 2'000'000;

template <class Scalar>
void add(const NodeStiffness<Scalar>& of, const Scalar& factor, NodeStiffness<Scalar>& sum) {
  sum.uu += factor * of.uu;
  sum.up += factor * of.up;
  sum.ww += factor * of.ww;
  sum.wp += factor * of.wp;
  sum.pp += factor * of.pp;
}

/// 1 + i omega tau.
template <class Scalar>
Scalar damping_of(const Link& link, double omega) {
  if constexpr (std::is_same_v<Scalar, double>) {
    static_cast<void>(link);
    static_cast<void>(omega);
    return 1.0;
  } else {
    return {1.0, omega * link.retardation};
  }
}

/// Whether two parts of a link have the same stiffness: equally long ones where nothing changes.
bool alike(const Link& link, const SpringElement& a, const SpringElement& b) {
  const double length = a.to - a.from;
  return link.stretches.size() == 1 && is_uniform(link.stretches.front()) &&
         std::abs(b.to - b.from - length) <= 1e-13 * length;
}

/// Calls f(part, its stiffness at z) for all parts of a link.
template <class Scalar, class Function>
void over_parts(const Link& link, const DividedLink& divided, const Scalar& z, const Function& f) {
  const SpringElement* known = nullptr;
  ExactPart<Scalar> part(link, divided.springs.front().from, divided.springs.front().to, z);
  for (std::size_t i = 0; i < divided.springs.size(); ++i) {
    const SpringElement& of = divided.springs[i];
    if (known != nullptr && !alike(link, *known, of)) {
      part = ExactPart<Scalar>(link, of.from, of.to, z);
    }
    known = &of;
    f(i, part);
  }
}

template <class Scalar>
void make_exact(const Link& link, const Scalar& damping, LinkStiffness<Scalar>& of) {
  of.exact_nodes.resize(of.divided->elements.size());
  of.exact_parts.resize(of.divided->springs.size());
  over_parts(link, *of.divided, Scalar(of.square / damping),
             [&](std::size_t i, const ExactPart<Scalar>& part) {
               add(part.start, damping, of.exact_nodes[i]);
               add(part.end, damping, of.exact_nodes[i + 1]);
               PartFlexibility<Scalar>& between = of.exact_parts[i];
               between = part.between;
               between.axial /= damping;
               between.f11 /= damping;
               between.f22 /= damping;
             });
}

bool is_exact(const Structure& structure, std::size_t link) {
  return structure.mechanism->element == Element::exact && !structure.links[link].springs.empty();
}

/// Whether all pieces of a link are resolved when its parts are cut.
bool resolves(const Link& link, const DividedLink& divided, int pieces, double square) {
  const SpringElement* known = nullptr;
  for (const SpringElement& part : divided.springs) {
    if (known != nullptr && alike(link, *known, part)) continue;
    known = &part;
    const double step = (part.to - part.from) / pieces;
    const bool uniform = alike(link, part, part);
    for (int i = 0; i < (uniform ? 1 : pieces); ++i) {
      if (!resolves(link, part.from + step * i, part.from + step * (i + 1), square)) return false;
    }
  }
  return true;
}

/// -dD/dz q of an exact link, by a step of z off the real numbers: no difference is taken.
template <class Scalar>
Eigen::Matrix<Scalar, 3, Eigen::Dynamic> exact_mass_times(
    const Link& link, const DividedLink& divided,
    const Eigen::Matrix<Scalar, 3, Eigen::Dynamic>& motion, double square) {
  constexpr double step = 1e-30;
  using Columns = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>;
  Columns product = Columns::Zero(3, motion.cols());
  const auto slope = [](const Complex& of) { return -of.imag() / step; };
  const auto add_node = [&](const NodeStiffness<Complex>& node, Eigen::Index at) {
    const auto q = motion.col(at);
    product(0, at) += slope(node.uu) * q[0];
    product(1, at) += slope(node.ww) * q[1] + slope(node.wp) * q[2];
    product(2, at) += slope(node.wp) * q[1] + slope(node.pp) * q[2];
  };
  over_parts(link, divided, Complex(square, step), [&](std::size_t i, const auto& part) {
    const auto a = static_cast<Eigen::Index>(i);
    const auto b = a + 1;
    add_node(part.start, a);
    add_node(part.end, b);
    const PartFlexibility<Complex>& of = part.between;
    if (link.kind != LinkKind::bending) {
      const Scalar n = slope(1.0 / of.axial) * (motion(0, b) - motion(0, a));
      product(0, a) -= n;
      product(0, b) += n;
    }
    if (link.kind == LinkKind::axial) return;
    // Of the spring's force Q = c (w_b + e_b phi_b - w_a - e_a phi_a): c and both levers change.
    const Complex c = 1.0 / of.f11;
    const double e_a = of.from_start.real(), e_b = of.from_end.real();
    const double de_a = slope(of.from_start), de_b = slope(of.from_end);
    const Scalar gap = motion(1, b) + e_b * motion(2, b) - motion(1, a) - e_a * motion(2, a);
    const Scalar Q = c.real() * gap;
    const Scalar dQ = slope(c) * gap + c.real() * (de_b * motion(2, b) - de_a * motion(2, a));
    const Scalar dm = slope(1.0 / of.f22) * (motion(2, b) - motion(2, a));
    product(1, a) -= dQ;
    product(1, b) += dQ;
    product(2, a) -= e_a * dQ + de_a * Q + dm;
    product(2, b) += e_b * dQ + de_b * Q + dm;
  });
  return product;
}

}  // namespace

template <class Scalar>
LinkStiffness<Scalar> link_stiffness_of(const Structure& structure, std::size_t link, double square,
                                        double omega) {
  const Link& of = structure.mechanism->links[link];
  const Scalar damping = damping_of<Scalar>(of, omega);
  LinkStiffness<Scalar> stiffness{&structure.links[link], square, 1.0 / damping};
  if (is_exact(structure, link)) make_exact(of, damping, stiffness);
  return stiffness;
}

int pieces_at(const Structure& structure, double square) {
  int pieces = 1;
  if (structure.mechanism->element != Element::exact) return pieces;
  const auto resolves_all = [&] {
    for (std::size_t k = 0; k < structure.links.size(); ++k) {
      if (!resolves(structure.mechanism->links[k], structure.links[k], pieces, square))
        return false;
    }
    return true;
  };
  while (!resolves_all()) {
    pieces *= 2;
    if (structure.elements() * static_cast<std::size_t>(pieces) > most_elements) {
      throw AnalysisError(
          {"the frequency is so high, or a stiffness changes so fast, that the "
           "exact form of the links takes too many pieces",
           "mechanism"});
    }
  }
  return pieces;
}

FinerStructure cut(const Structure& of, int pieces) {
  FinerStructure result{of, pieces};
  Structure& finer = result.structure;
  const auto count = static_cast<std::size_t>(pieces);
  for (std::size_t k = 0; k < of.links.size(); ++k) {
    const DividedLink& link = of.links[k];
    if (link.springs.empty()) continue;
    DividedLink& fine = finer.links[k];
    fine = {};
    for (const SpringElement& part : link.springs) {
      const double step = (part.to - part.from) / pieces;
      for (std::size_t i = 0; i < count; ++i) {
        SpringElement& piece = fine.springs.emplace_back();
        piece.from = part.from + step * static_cast<double>(i);
        piece.to = i + 1 == count ? part.to : part.from + step * static_cast<double>(i + 1);
        piece.place = 0.5 * (piece.from + piece.to);
        fine.elements.emplace_back().node = piece.from;
      }
    }
    fine.elements.emplace_back().node = link.elements.back().node;
  }
  const auto move = [&](Grip& grip) {
    if (grip.link == ground) return;
    if (of.links[static_cast<std::size_t>(grip.link)].springs.empty()) return;
    grip.element *= count;
  };
  for (Structure::Ends& ends : finer.joints) {
    move(ends.a);
    move(ends.b);
  }
  for (Grip& grip : finer.loads) move(grip);
  return result;
}

template <class Scalar>
LinkColumns<Scalar> mass_times(const Structure& structure, const LinkColumns<Scalar>& motion,
                               double square) {
  LinkColumns<Scalar> product(motion.size());
  for (std::size_t k = 0; k < motion.size(); ++k) {
    if (is_exact(structure, k)) {
      product[k] = exact_mass_times<Scalar>(structure.mechanism->links[k], structure.links[k],
                                            motion[k], square);
      continue;
    }
    product[k].resize(3, motion[k].cols());
    for (Eigen::Index i = 0; i < motion[k].cols(); ++i) {
      product[k].col(i) =
          mass_times(structure.links[k].elements[static_cast<std::size_t>(i)], motion[k].col(i));
    }
  }
  return product;
}

template <class Scalar>
Deformation<Scalar> at_coarse_nodes(const FinerStructure& finer, const Deformation<Scalar>& of) {
  Deformation<Scalar> result;
  result.joints = of.joints;
  for (std::size_t k = 0; k < of.motion.size(); ++k) {
    const Eigen::Index step = of.motion[k].cols() > 1 ? finer.pieces : 1;
    const Eigen::Index count = (of.motion[k].cols() - 1) / step + 1;
    result.motion.emplace_back(3, count);
    for (Eigen::Index i = 0; i < count; ++i) result.motion[k].col(i) = of.motion[k].col(i * step);
  }
  return result;
}

template <class Scalar>
LinkColumns<Scalar> at_finer_nodes(const FinerStructure& finer, const LinkColumns<Scalar>& of) {
  LinkColumns<Scalar> result = no_loads<Scalar>(finer.structure);
  for (std::size_t k = 0; k < of.size(); ++k) {
    for (Eigen::Index i = 0; i < of[k].cols(); ++i) {
      result[k].col(of[k].cols() > 1 ? i * finer.pieces : i) = of[k].col(i);
    }
  }
  return result;
}

template LinkStiffness<double> link_stiffness_of(const Structure&, std::size_t, double, double);
template LinkStiffness<Complex> link_stiffness_of(const Structure&, std::size_t, double, double);
template LinkColumns<double> mass_times(const Structure&, const LinkColumns<double>&, double);
template LinkColumns<Complex> mass_times(const Structure&, const LinkColumns<Complex>&, double);
template Deformation<double> at_coarse_nodes(const FinerStructure&, const Deformation<double>&);
template Deformation<Complex> at_coarse_nodes(const FinerStructure&, const Deformation<Complex>&);
template LinkColumns<double> at_finer_nodes(const FinerStructure&, const LinkColumns<double>&);
template LinkColumns<Complex> at_finer_nodes(const FinerStructure&, const LinkColumns<Complex>&);

}  // namespace boxbeam::flexible
