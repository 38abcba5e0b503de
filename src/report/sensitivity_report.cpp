#include "boxbeam/report/sensitivity_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "blocks.hpp"
#include "document_fields.hpp"
#include "drawn_files.hpp"
#include "ink.hpp"
#include "text_layout.hpp"

namespace boxbeam {
namespace {

constexpr std::size_t most_bars = 16;

/// "-" where it cannot be verified, "?" where it is not known.
std::string side_text(const std::optional<SideSlope>& side) {
  if (!side) return "-";
  if (!side->is_known()) return "?";
  constexpr double shown = 0.005;  // with two digits behind the point
  return std::abs(side->slope) < shown ? std::string("0") : fmt::format("{:+.2f}", side->slope);
}

std::string slope_text(const Sensitivity& input, Criterion criterion) {
  const auto found = input.slopes.find(criterion);
  if (found == input.slopes.end()) return "-";
  const std::string down = side_text(found->second.down), up = side_text(found->second.up);
  return down == up ? up : fmt::format("{} | {}", down, up);
}

constexpr const char* of_two_sides =
    "Where two stand, another place or clause governs on the two sides: that of less before, that "
    "of more behind, - where that cannot be verified. A question mark: the factor jumps or bends "
    "close by, so that it has no slope, as where a check is listed for some of the values only.";

const std::string explanation = fmt::format(
    "By how many percent the governing safety factor of a criterion changes where an input grows "
    "by one percent: +1 in proportion, -3 with the third power against it. {}",
    of_two_sides);

std::string not_verified_text(const Sensitivities& of) {
  return fmt::format("of {} neither side can be verified: {}", of.not_verified.size(),
                     fmt::join(of.not_verified, ", "));
}

/// What is said below: inputs that are not in the table.
std::string rest_text(const Sensitivities& of) {
  std::string text = fmt::format("{} more inputs change no factor by {} % per percent",
                                 of.without_effect, least_slope);
  if (!of.not_verified.empty()) text += "; " + not_verified_text(of);
  return text + ".";
}

plot::Drawing bars_of(const Sensitivities& of) {
  const Criterion criterion = of.criteria.front();
  std::vector<const Sensitivity*> shown;
  double most = 0.0;
  for (const Sensitivity& input : of.inputs) {
    const auto found = input.slopes.find(criterion);
    if (found == input.slopes.end()) continue;
    const SideSlope of_both = found->second.of_both();
    if (!of_both.is_known() || std::abs(of_both.slope) < least_slope) continue;
    if (shown.size() < most_bars) shown.push_back(&input);
    most = std::max(most, std::abs(of_both.slope));
  }
  constexpr double row = 19.0, names = 250.0, below = plot::footing_room;
  const double height = row * static_cast<double>(shown.size());
  plot::Drawing drawing{plot::figure_width, below + height + plot::heading_room, {}};
  const plot::Panel panel{{names, below, plot::figure_width - 16.0, below + height},
                          -1.1 * most,
                          1.1 * most,
                          0.0,
                          static_cast<double>(shown.size())};
  plot::put_axes(drawing, panel, false);
  plot::put_heading(drawing, panel,
                    fmt::format("{}: change of the governing factor", to_text(criterion)));
  plot::put_footing(drawing, panel, "% for one percent more of the input");
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const double middle = static_cast<double>(shown.size() - i) - 0.5;
    const double slope = shown[i]->slopes.at(criterion).value();
    plot::put_named_bar(drawing, panel, middle, slope, plot::colour(slope < 0.0 ? 1 : 0),
                        fmt::format("{}  {}", shown[i]->key, to_text(shown[i]->value)), names);
  }
  plot::put_line(drawing, panel.at(0.0, panel.y_low), panel.at(0.0, panel.y_high),
                 {"#202020", 1.2});
  return drawing;
}

}  // namespace

report::Chapter sensitivity_chapter(const Sensitivities& of) {
  report::Chapter chapter{"What changes the factors", {}};
  chapter.blocks.emplace_back(report::Paragraph{explanation});
  if (!of.criteria.empty())
    chapter.blocks.emplace_back(report::Picture{
        sensitivity_figure,
        fmt::format("What changes the factor of {} most.", to_text(of.criteria.front()))});
  std::vector<std::string> header{"input", "value"};
  for (const Criterion criterion : of.criteria) header.emplace_back(to_text(criterion));
  report::Table table = report::table_of("Slopes of the governing factors", header);
  for (const Sensitivity& input : of.inputs) {
    std::vector<report::Cell> cells{report::cell(input.key), report::cell(to_text(input.value))};
    for (const Criterion criterion : of.criteria) {
      const auto found = input.slopes.find(criterion);
      cells.push_back({slope_text(input, criterion), found == input.slopes.end()
                                                         ? std::optional<double>()
                                                         : found->second.value()});
    }
    add_row(table, std::move(cells));
  }
  table.folded = report::is_long(table);
  chapter.blocks.emplace_back(std::move(table));
  chapter.blocks.emplace_back(report::Paragraph{rest_text(of)});
  return chapter;
}

std::string sensitivity_text(const Sensitivities& of) {
  if (of.criteria.empty()) return "";
  constexpr std::size_t most_rows = 8, most_criteria = 4;
  std::vector<std::string> header{"input", "value"};
  const std::size_t count = std::min(most_criteria, of.criteria.size());
  for (std::size_t k = 0; k < count; ++k) header.emplace_back(to_text(of.criteria[k]));
  layout::Table table(header);
  bool is_plain = true;
  for (std::size_t i = 0; i < std::min(most_rows, of.inputs.size()); ++i) {
    std::vector<std::string> row{of.inputs[i].key, to_text(of.inputs[i].value)};
    for (std::size_t k = 0; k < count; ++k) {
      row.push_back(slope_text(of.inputs[i], of.criteria[k]));
      is_plain = is_plain && row.back().find_first_of("|?") == std::string::npos;
    }
    table.row(row);
  }
  std::string text =
      "\nWhat changes the factors most, in percent for one percent more of the input:\n" +
      table.text();
  if (!is_plain) text += layout::paragraph(of_two_sides);
  if (of.inputs.size() > most_rows)
    text += layout::paragraph(
        fmt::format("{} more inputs stand in the report", of.inputs.size() - most_rows));
  if (!of.not_verified.empty()) text += layout::paragraph(not_verified_text(of));
  return text;
}

void draw_sensitivities(const Sensitivities& of, const std::string& folder,
                        const std::string& tex_folder) {
  draw_into(folder, tex_folder, {{sensitivity_figure, [&] { return bars_of(of); }}});
}

void report::put_sensitivities(Fields& to, const Sensitivities& of) {
  to.optional().list(
      {"sensitivities",
       "where asked for: inputs of the case and by how much of itself each criterion's governing "
       "factor changes with them, d(ln f)/d(ln x)"},
      "{input}", of.inputs, [&](Fields& fields, const Sensitivity& input) {
        fields.text({"input", "key of the case"}, input.key);
        fields.text({"written", "its value there"}, to_text(input.value));
        using Entry = std::pair<Criterion, Slope>;
        const std::vector<Entry> slopes(input.slopes.begin(), input.slopes.end());
        fields.list("slopes", "{criterion}", slopes, [](Fields& at, const Entry& entry) {
          at.text("criterion", to_text(entry.first));
          const Slope& slope = entry.second;
          const auto of_side = [](const std::optional<SideSlope>& side) {
            return side ? std::optional(side->slope) : std::nullopt;
          };
          const auto error_of = [](const std::optional<SideSlope>& side) {
            return side ? side->error : 0.0;
          };
          at.number({"slope", "of both sides; where these differ the steeper one that is known"},
                    "1", slope.value());
          at.number_or_null({"down", "towards less; null where that cannot be verified"}, "1",
                            of_side(slope.down));
          at.number_or_null({"up", "towards more"}, "1", of_side(slope.up));
          at.number({"error", "by how much these may be off; large where it jumps"}, "1",
                    std::max(error_of(slope.down), error_of(slope.up)));
        });
      });
  to.optional().texts(
      {"sensitivities_not_verified", "inputs of which neither side can be verified"},
      [&] { return of.not_verified; });
}

}  // namespace boxbeam
