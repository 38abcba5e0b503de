#include "boxbeam/project/standard_profiles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

struct Size {
  std::string outside;        ///< "200x100", "100", "168.3"; mm
  std::vector<double> walls;  ///< [m]
};

struct Series {
  std::string name;  ///< "RHS"
  std::string source;
  bool unconfirmed = false;
  std::vector<Size> sizes;
};

std::vector<Series> read_series() {
  const CaseDocument document =
      parse_document("hollow-sections.toml", catalogue_data::hollow_sections, {});
  ProblemList problems(document);
  std::vector<Series> all;
  for (auto& [name, table] : TableReader(problems, document.root, "").named_tables()) {
    Series series{name, table.text("source"), table.boolean("unconfirmed", false), {}};
    TableReader walls = table.table("walls");
    for (const Node::Member& member : walls.members()) {
      series.sizes.push_back({member.key, walls.quantities(member.key, wanted::length)});
    }
    all.push_back(std::move(series));
  }
  problems.raise();
  return all;
}

const std::vector<Series>& catalogue() {
  static const std::vector<Series> all = read_series();
  return all;
}

/// A designation in parts: series, outside and wall as written.
struct Parts {
  std::string series, outside, wall;
};

Parts parts_of(const std::string& designation) {
  const std::size_t gap = designation.find(' ');
  if (gap == std::string::npos) return {designation, "", ""};
  const std::string rest = designation.substr(gap + 1);
  const std::size_t last = rest.rfind('x');
  if (last == std::string::npos) return {designation.substr(0, gap), rest, ""};
  return {designation.substr(0, gap), rest.substr(0, last), rest.substr(last + 1)};
}

const Series* series_of(const Parts& parts) {
  const auto found = std::find_if(catalogue().begin(), catalogue().end(),
                                  [&](const Series& one) { return one.name == parts.series; });
  return found == catalogue().end() ? nullptr : &*found;
}

const Size* size_of(const Series& series, const Parts& parts) {
  const auto found = std::find_if(series.sizes.begin(), series.sizes.end(),
                                  [&](const Size& one) { return one.outside == parts.outside; });
  return found == series.sizes.end() ? nullptr : &*found;
}

std::optional<double> millimetres(const std::string& text) {
  const auto parsed = parse_quantity(text + " mm");
  const auto* quantity = std::get_if<ParsedQuantity>(&parsed);
  return quantity == nullptr ? std::nullopt : std::optional(quantity->value);
}

Profile profile_of(const std::string& series, const std::string& outside, double wall) {
  const Length t = si<Length>(wall);
  const std::size_t cross = outside.find('x');
  const Length first = si<Length>(millimetres(outside.substr(0, cross)).value());
  if (series == "CHS") return RoundTube{first, t};
  const Length width = cross == std::string::npos
                           ? first
                           : si<Length>(millimetres(outside.substr(cross + 1)).value());
  return RectangularTube{width, first, t, 1.5 * t, 1.0 * t};
}

}  // namespace

std::optional<StandardProfile> find_standard_profile(const std::string& designation) {
  const Parts parts = parts_of(designation);
  const Series* series = series_of(parts);
  const Size* size = series == nullptr ? nullptr : size_of(*series, parts);
  const auto wall = millimetres(parts.wall);
  if (size == nullptr || !wall) return std::nullopt;
  for (const double known : size->walls) {
    if (std::abs(known - *wall) < 1e-9) {
      return StandardProfile{profile_of(series->name, size->outside, known), series->source,
                             series->unconfirmed};
    }
  }
  return std::nullopt;
}

std::string standard_profile_hint(const std::string& designation) {
  const Parts parts = parts_of(designation);
  const Series* series = series_of(parts);
  if (series == nullptr) return "write \"RHS 200x100x8\", \"SHS 100x5\" or \"CHS 168.3x8\"";
  std::vector<std::string> known;
  if (const Size* size = size_of(*series, parts)) {
    for (const double wall : size->walls) known.push_back(fmt::format("{:.6g}", wall * 1e3));
    return fmt::format("{} {} has the walls {} mm", series->name, size->outside,
                       fmt::join(known, ", "));
  }
  for (const Size& size : series->sizes) known.push_back(size.outside);
  return fmt::format("{} is known as {}", series->name, fmt::join(known, ", "));
}

}  // namespace boxbeam
