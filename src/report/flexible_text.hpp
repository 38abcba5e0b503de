#pragma once

#include <string>

#include "boxbeam/mechanism/flexible/mechanism.hpp"
#include "boxbeam/verification/elastic_figures.hpp"

namespace boxbeam {

/// The loads of a mechanism of elastic links and how it is divided, in words, an entry for each.
std::string flexible_inputs(const flexible::Mechanism& mechanism);

/// Its links and joints as tables, and what the model takes otherwise.
std::string flexible_tables(const flexible::Mechanism& mechanism, const ElasticModel& model);

/// Natural frequencies and joint forces, static and vibrating, with the errors of division, and of
/// which model they are beside the chosen one.
std::string vibration_section(const ElasticFigures& figures, const ElasticModel& model);

}  // namespace boxbeam
