#include <fmt/format.h>

#include <map>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {
namespace {

using text::Quantity;

/// What the checks found at one point of one station.
struct PointStresses {
  const CheckResult* fatigue = nullptr;  ///< its normal stress over the history
  const CheckResult* yield = nullptr;

  double range() const {
    return fatigue == nullptr ? 0.0 : fatigue->basis->highest.value - fatigue->basis->lowest.value;
  }
  double equivalent() const { return yield == nullptr ? 0.0 : yield->check.acting.value(); }
};

/// A station and a point, ordered along the beam.
struct PointKey {
  Length s;
  int side;
  std::string point;
  auto tied() const { return std::tie(s, side, point); }
  friend bool operator<(const PointKey& a, const PointKey& b) { return a.tied() < b.tied(); }
};

using StressMap = std::map<PointKey, PointStresses>;

StressMap stresses_of(const Verification& verification) {
  StressMap map;
  for (const CheckResult& result : verification.checks) {
    if (!result.basis) continue;
    const Check& check = result.check;
    const PointKey key{check.station.s, static_cast<int>(check.station.side), check.point};
    if (check.criterion == Criterion::fatigue) map[key].fatigue = &result;
    if (check.criterion == Criterion::yield) map[key].yield = &result;
  }
  return map;
}

Table table_with(std::string caption) {
  return table_of(std::move(caption), {"s [m]", "point", "sigma min [MPa]", "sigma max [MPa]",
                                       "range [MPa]", "sigma_v max [MPa]"});
}

void add_point(const PointStresses& of, Table& table) {
  const Check& check = (of.fatigue != nullptr ? of.fatigue : of.yield)->check;
  std::vector<Cell> row = row_of(to_text(check.station), check.point);
  if (of.fatigue != nullptr) {
    row.push_back(cell(Quantity::stress, of.fatigue->basis->lowest.value));
    row.push_back(cell(Quantity::stress, of.fatigue->basis->highest.value));
    row.push_back(cell(Quantity::stress, of.range()));
  } else {
    row.insert(row.end(), 3, cell("-"));
  }
  row.push_back(of.yield != nullptr ? cell(Quantity::stress, of.equivalent()) : cell("-"));
  add_row(table, std::move(row));
}

/// Of every station the point whose range, or else whose equivalent stress, is largest.
Table worst_table(const StressMap& stresses) {
  Table table = table_with("Of every station the point with the largest range of normal stress");
  for (auto it = stresses.begin(); it != stresses.end();) {
    const PointStresses* worst = &it->second;
    const PointKey& key = it->first;
    for (; it != stresses.end() && it->first.s == key.s && it->first.side == key.side; ++it) {
      const PointStresses& other = it->second;
      if (std::pair(other.range(), other.equivalent()) >
          std::pair(worst->range(), worst->equivalent())) {
        worst = &other;
      }
    }
    add_point(*worst, table);
  }
  return table;
}

Table given_table(const Project& project) {
  Table table =
      table_of("Given by the case, not computed here; what they come from stands in the remarks",
               {"point", "s [m]", "t [s]", "largest [MPa]", "opposite [MPa]", "plate [mm]"});
  for (const GivenStress& given : project.given_stresses) {
    add_row(
        table,
        row_of(given.name, cell(Quantity::station, given.s.value()),
               cell(Quantity::time, given.time.value()), cell(Quantity::stress, given.peak.value()),
               given.opposite ? cell(Quantity::stress, given.opposite->value()) : cell("-"),
               cell(Quantity::length, given.thickness.value())));
  }
  return table;
}

}  // namespace

Chapter stress_chapter(const Source& source) {
  Chapter chapter{"Stresses", {}};
  if (source.level == ReportLevel::summary) return chapter;
  if (!source.project.given_stresses.empty()) {
    chapter.blocks.emplace_back(given_table(source.project));
    return chapter;
  }
  add_pictures(source, FigurePlace::stresses, chapter.blocks);
  const StressMap stresses = stresses_of(source.verification);
  if (stresses.empty()) return chapter;
  chapter.blocks.emplace_back(Paragraph{
      "Normal stress with holes, shear lag and stress concentration, over all situations; sigma_v "
      "is the equivalent stress (von Mises) with the load factors of the strength check."});
  chapter.blocks.emplace_back(worst_table(stresses));
  if (source.level != ReportLevel::full) return chapter;
  Table all = table_with("All points");
  for (const auto& [key, of] : stresses) add_point(of, all);
  chapter.blocks.emplace_back(std::move(all));
  return chapter;
}

}  // namespace boxbeam::report
