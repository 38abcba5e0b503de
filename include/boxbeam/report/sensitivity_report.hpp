#pragma once

#include <string>

#include "boxbeam/report/document.hpp"
#include "boxbeam/study/sensitivities.hpp"

namespace boxbeam {

/// Name of the figure, without its end.
inline constexpr const char* sensitivity_figure = "sensitivities";

/// The chapter of a report: what changes the governing factors, with a figure of the most used
/// criterion.
report::Chapter sensitivity_chapter(const Sensitivities& of);

/// The same for a terminal, in short.
std::string sensitivity_text(const Sensitivities& of);

/// Draws the figure into a folder, NAME.svg, and where `tex_folder` is not empty NAME.tex there.
void draw_sensitivities(const Sensitivities& of, const std::string& folder,
                        const std::string& tex_folder);

}  // namespace boxbeam
