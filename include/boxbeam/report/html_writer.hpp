#pragma once

#include <functional>
#include <optional>
#include <string>

#include "boxbeam/report/document.hpp"

namespace boxbeam::report {

/// The SVG of a figure by its name; nothing where it was not drawn.
using Pictures = std::function<std::optional<std::string>(const std::string& name)>;

/// A report as one HTML file that needs nothing beside it: style, script, figures and fonts are
/// inside, nothing is fetched. Without script everything but the moving picture and the sorting of
/// tables works.
std::string html_of(const Document& document, const Pictures& pictures);

}  // namespace boxbeam::report
