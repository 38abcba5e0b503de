#include "boxbeam/project/catalogue.hpp"

#include <cassert>
#include <utility>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

/// A steel by both sources.
struct Steel {
  Material product;  ///< EN 10025-2
  Material design;   ///< EN 1993-1-1
};

Material read_strengths(TableReader table, std::string name, std::string source, double beta_w) {
  Material steel{std::move(name), std::move(source), beta_w, {}};
  const std::vector<double> up_to = table.quantities("up_to", wanted::length);
  const std::vector<double> yield = table.quantities("yield", wanted::stress);
  const std::vector<double> tensile = table.quantities("tensile", wanted::stress);
  assert(up_to.size() == yield.size() && up_to.size() == tensile.size());
  for (std::size_t i = 0; i < up_to.size(); ++i) {
    steel.steps.push_back({si<Length>(up_to[i]), si<Stress>(yield[i]), si<Stress>(tensile[i])});
  }
  table.finish();
  return steel;
}

std::vector<Steel> read_steels() {
  const CaseDocument document = parse_document("steels.toml", catalogue_data::steels, {});
  ProblemList problems(document);
  std::vector<Steel> steels;
  for (auto& [name, table] : TableReader(problems, document.root, "").named_tables()) {
    const double beta_w = table.number("beta_w");
    steels.push_back({read_strengths(table.table(to_text(SteelSource::en_10025_2)), name,
                                     "EN 10025-2, table 7", beta_w),
                      read_strengths(table.table(to_text(SteelSource::en_1993_1_1)), name,
                                     "EN 1993-1-1:2005, table 3.1", beta_w)});
    table.finish();
  }
  problems.raise();
  return steels;
}

const std::vector<Steel>& steels() {
  static const std::vector<Steel> all = read_steels();
  return all;
}

const Steel* steel_named(const std::string& name) {
  for (const Steel& steel : steels()) {
    if (steel.product.name == name) return &steel;
  }
  return nullptr;
}

}  // namespace

const char* to_text(SteelSource source) {
  return source == SteelSource::en_10025_2 ? "EN 10025-2" : "EN 1993-1-1";
}

std::optional<Material> find_steel(const std::string& name) {
  const Steel* steel = steel_named(name);
  if (steel == nullptr) return std::nullopt;
  return lower_of(steel->product, steel->design);
}

std::optional<Material> find_steel(const std::string& name, SteelSource source) {
  const Steel* steel = steel_named(name);
  if (steel == nullptr) return std::nullopt;
  return source == SteelSource::en_10025_2 ? steel->product : steel->design;
}

std::vector<std::string> steel_names() {
  std::vector<std::string> names;
  for (const Steel& steel : steels()) names.push_back(steel.product.name);
  return names;
}

}  // namespace boxbeam
