#include "program/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "boxbeam/core/error.hpp"
#include "boxbeam/project/catalogue.hpp"
#include "boxbeam/project/named_section.hpp"
#include "boxbeam/project/quantity_text.hpp"
#include "boxbeam/report/section_text.hpp"
#include "boxbeam/verification/section_summary.hpp"
#include "program/exit_code.hpp"
#include "program/outputs.hpp"
#include "program/terminal.hpp"

namespace boxbeam::program {

namespace {

CutForces forces_of(const std::string& text) {
  struct Named {
    const char* name;
    WantedDimension wanted;
  };
  const std::array<Named, cut_force::count> known{{{"N", wanted::force},
                                                   {"V_y", wanted::force},
                                                   {"V_z", wanted::force},
                                                   {"T", wanted::moment},
                                                   {"M_y", wanted::moment},
                                                   {"M_z", wanted::moment}}};
  const char* const example = "write for example --forces \"N = -600 kN, M_y = 1500 kN m\"";
  std::array<double, cut_force::count> values{};
  std::array<bool, cut_force::count> said{};
  const auto trimmed = [](std::string_view of) {
    const std::size_t first = of.find_first_not_of(' ');
    if (first == std::string_view::npos) return std::string();
    return std::string(of.substr(first, of.find_last_not_of(' ') - first + 1));
  };
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const std::string part = trimmed(std::string_view(text).substr(from, to - from));
    from = to + 1;
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos)
      throw InputError(fmt::format("--forces: \"{}\" is not a name, =, and a value", part),
                       example);
    const std::string name = trimmed(std::string_view(part).substr(0, equals));
    const auto at =
        std::find_if(known.begin(), known.end(), [&](const Named& of) { return of.name == name; });
    if (at == known.end()) {
      throw InputError(fmt::format("--forces: there is no cut force \"{}\"", name),
                       "known are N, V_y, V_z, T, M_y, M_z");
    }
    const auto index = static_cast<std::size_t>(at - known.begin());
    if (said[index])
      throw InputError(fmt::format("--forces: {} stands twice", name), "write each once");
    said[index] = true;
    const auto parsed = parse_quantity(trimmed(std::string_view(part).substr(equals + 1)));
    const auto* const quantity = std::get_if<ParsedQuantity>(&parsed);
    if (quantity == nullptr || quantity->exponents != at->wanted.exponents) {
      throw InputError(fmt::format("--forces: {} is {}, not \"{}\"", name, at->wanted.name,
                                   trimmed(std::string_view(part).substr(equals + 1))),
                       example);
    }
    values[index] = quantity->value;
  }
  return {si<Force>(values[0]),  si<Force>(values[1]),  si<Force>(values[2]),
          si<Moment>(values[3]), si<Moment>(values[4]), si<Moment>(values[5])};
}

}  // namespace

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
    if (!options.forces.empty()) {
      summaries.back().under = std::make_shared<const SectionUnderForces>(
          section_under(section.section, *steel, forces_of(options.forces)));
    }
    if (!text.empty()) text += "\n";
    text += section_text(summaries.back());
  }
  put_result(options.json, section_json(summaries), text);
  return all_pass;
}

}  // namespace boxbeam::program
