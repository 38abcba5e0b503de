#pragma once

namespace boxbeam::report {

/// The house style of the PDF: page, type, colours, and the commands that the writer uses.
extern const char* const latex_preamble;

}  // namespace boxbeam::report
