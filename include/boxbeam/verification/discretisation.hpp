#pragma once

#include <Eigen/Core>
#include <optional>

#include "boxbeam/mechanism/flexible/structure.hpp"

namespace boxbeam {

/// The mechanism of a structure with every part of its links cut into `factor` equal ones: all its
/// nodes stay nodes, so that what is computed converges without jumps.
flexible::Mechanism refined(const flexible::Structure& structure, int factor);

/// How far a value of the structure may be from that of links divided without end.
struct DiscretisationError {
  double error = 0.0;           ///< absolute, in the unit of the value
  std::optional<double> order;  ///< of convergence; nothing where it is not seen
};

/// From the values of the structure itself and of it refined by 2 and by 4; vectors by the length
/// of their difference. With d_1 = |f_n - f_2n|, d_2 = |f_2n - f_4n|:
///
///     p = log2(d_1/d_2),   error = 1.25 d_1 2^p/(2^p - 1)   where 1 <= p <= 5
///     error = 3 max(d_1, d_2, |f_n - f_4n|)                 where p is not such an order
///
/// An estimate with a margin, no bound. Source: Richardson (1911); Roache, Journal of Fluids
/// Engineering 116 (1994): grid convergence index, factors 1.25 and 3.
DiscretisationError discretisation_error(const Eigen::VectorXd& own, const Eigen::VectorXd& by_2,
                                         const Eigen::VectorXd& by_4);

}  // namespace boxbeam
