#include "boxbeam/verification/discretisation.hpp"

#include <algorithm>
#include <cmath>

namespace boxbeam {
namespace {

using flexible::LinkStretch;

template <int Degree>
Polynomial<Degree> moved(const Polynomial<Degree>& p, double by, double length) {
  return interpolate<Degree>([&](double x) { return p(by + x); }, length);
}

/// The piece of a stretch between two places of the link.
LinkStretch piece_of(const LinkStretch& of, double from, double to) {
  const double by = from - of.start;
  const double length = to - from;
  return {from,
          length,
          moved(of.EA, by, length),
          moved(of.GA, by, length),
          moved(of.EI, by, length),
          moved(of.mass, by, length),
          moved(of.rotary, by, length)};
}

}  // namespace

flexible::Mechanism refined(const flexible::Structure& structure, int factor) {
  flexible::Mechanism mechanism = *structure.mechanism;
  for (std::size_t k = 0; k < mechanism.links.size(); ++k) {
    flexible::Link& link = mechanism.links[k];
    const std::vector<flexible::SpringElement>& parts = structure.links[k].springs;
    if (parts.empty()) continue;
    if (!mechanism.nodes_at_joints) {  // all parts are equal
      link.parts = static_cast<int>(parts.size()) * factor;
      continue;
    }
    // A stretch for every part, which then has one: ends of stretches are nodes.
    const std::vector<LinkStretch> whole = std::move(link.stretches);
    link.stretches.clear();
    link.parts = 1;
    auto of = whole.begin();
    for (const flexible::SpringElement& part : parts) {
      const double middle = 0.5 * (part.from + part.to);
      while (of != whole.end() - 1 && middle >= of->start + of->length) ++of;
      for (int i = 0; i < factor; ++i) {
        const double step = (part.to - part.from) / factor;
        const double to = i + 1 == factor ? part.to : part.from + step * (i + 1);
        link.stretches.push_back(piece_of(*of, part.from + step * i, to));
      }
    }
  }
  return mechanism;
}

DiscretisationError discretisation_error(const Eigen::VectorXd& own, const Eigen::VectorXd& by_2,
                                         const Eigen::VectorXd& by_4) {
  const double d_1 = (own - by_2).norm();
  const double d_2 = (by_2 - by_4).norm();
  const double p = d_1 > 0.0 && d_2 > 0.0 ? std::log2(d_1 / d_2) : 0.0;
  if (p >= 1.0 && p <= 5.0) return {1.25 * d_1 * std::exp2(p) / (std::exp2(p) - 1.0), p};
  return {3.0 * std::max({d_1, d_2, (own - by_4).norm()}), {}};
}

}  // namespace boxbeam
