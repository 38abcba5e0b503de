#include "boxbeam/report/formula.hpp"

#include "boxbeam/report/formula_tree.hpp"

namespace boxbeam::report {

bool is_formula(const std::string& text) { return parse_formula(text).has_value(); }

}  // namespace boxbeam::report
