#include "html_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/core/code_points.hpp"
#include "html_text.hpp"
#include "json_number.hpp"

namespace boxbeam::report::html {
namespace {

/// Five significant digits, which a diagram does not show.
Json number_of(double value) {
  return std::isfinite(value) ? Json::parse(fmt::format("{:.5g}", value)) : Json();
}

/// Words once each, designs by the place of theirs.
void put_words(Json& column, const std::vector<std::string>& words) {
  std::vector<std::string> names = words;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  Json shown = Json::array(), places = Json::array();
  for (const std::string& name : names) shown.push_back(visible(name));
  for (const std::string& word : words)
    places.push_back(std::lower_bound(names.begin(), names.end(), word) - names.begin());
  column["words"] = std::move(shown);
  column["values"] = std::move(places);
}

Json column_of(const DesignColumn& of) {
  Json column = {{"name", visible(of.column.name)}, {"unit", visible(of.column.unit)}};
  if (of.is_variable) column["variable"] = true;
  if (of.numbers.empty()) {
    put_words(column, of.words);
    return column;
  }
  Json values = Json::array();
  for (const double value : of.numbers) values.push_back(number_of(value));
  column["values"] = std::move(values);
  return column;
}

std::string data_of(const DesignTable& table) {
  const DesignRows& rows = table.rows;
  Json columns = Json::array();
  for (const DesignColumn& column : rows.columns) columns.push_back(column_of(column));
  Json data = {{"designs", rows.designs},
               {"scatters", rows.scatters},
               {"begin",
                {{"x", visible(table.x)},
                 {"y", visible(table.y)},
                 {"colour", visible(table.colour)},
                 {"counted", visible(table.counted)}}},
               {"columns", std::move(columns)}};
  if (rows.size() < rows.designs) data["numbers"] = rows.numbers;
  return harmless(data.dump(-1, ' ', true, Json::error_handler_t::replace));
}

}  // namespace

std::string designs_figure(const DesignTable& table) {
  return fmt::format(
      "<figure class=\"designs\">\n<noscript><p>With scripts allowed the designs can be filtered "
      "here, and drawn against each other.</p></noscript>\n"
      "<script type=\"application/json\">{}</script>\n"
      "<figcaption>{}</figcaption>\n</figure>\n",
      data_of(table), escaped(table.caption));
}

}  // namespace boxbeam::report::html
