#include "program/section_command.hpp"

#include <fmt/format.h>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/named_section.hpp"
#include "boxbeam/report/section_text.hpp"
#include "boxbeam/verification/section_summary.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {

int run_section(const SectionOptions& options) {
  const auto steel = find_steel(options.steel);
  if (!steel) {
    throw InputError(fmt::format("there is no steel \"{}\"", options.steel),
                     fmt::format("known are {}", fmt::join(steel_names(), ", ")));
  }
  require_file(options.json);
  std::vector<SectionSummary> summaries;
  std::string text;
  for (const NamedSection& section : sections_from_words(options.profiles)) {
    summaries.push_back(summary_of(section, *steel));
    if (!text.empty()) text += "\n";
    text += section_text(summaries.back());
  }
  put_result(options.json, section_json(summaries), text);
  return all_pass;
}

}  // namespace boxbeam::program
