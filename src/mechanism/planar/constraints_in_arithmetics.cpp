// The constraint equations for studies of precision; a source of their own, so that the compiler's
// budget for inlining is all for those in double.

#include "boxbeam/numerics/decimal.hpp"
#include "constraints_of.hpp"

namespace boxbeam::planar {

template class ConstraintEquationsOf<float>;
template class ConstraintEquationsOf<long double>;
template class ConstraintEquationsOf<Decimal<5>>;

}  // namespace boxbeam::planar
