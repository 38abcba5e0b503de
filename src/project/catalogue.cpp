#include "boxbeam/project/catalogue.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

/// A steel by its sources.
struct Steel {
  std::vector<std::string> names;
  struct Source {
    std::string name;
    Material strengths;
  };
  std::vector<Source> sources;
};

struct SourceName {
  const char* name;
  const char* place;  ///< with the table
};

constexpr SourceName sources[] = {{"EN 10025-2", "EN 10025-2, table 7"},
                                  {"EN 10025-3", "EN 10025-3:2004"},
                                  {"EN 10025-4", "EN 10025-4:2004"},
                                  {"EN 10025-6", "EN 10025-6:2004"},
                                  {"EN 1993-1-1", "EN 1993-1-1:2005, table 3.1"},
                                  {"EN 1993-1-12", "EN 1993-1-12:2007, table 1"}};

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
    Steel steel{{name}, {}};
    if (table.has("also")) {
      for (std::string& other : table.texts("also", true)) steel.names.push_back(std::move(other));
    }
    for (const SourceName& source : sources) {
      if (!table.has(source.name)) continue;
      steel.sources.push_back(
          {source.name, read_strengths(table.table(source.name), name, source.place, beta_w)});
    }
    assert(!steel.sources.empty());
    steels.push_back(std::move(steel));
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
    if (std::find(steel.names.begin(), steel.names.end(), name) != steel.names.end()) return &steel;
  }
  return nullptr;
}

}  // namespace

std::optional<Material> find_steel(const std::string& name) {
  const Steel* steel = steel_named(name);
  if (steel == nullptr) return std::nullopt;
  Material lower = steel->sources.front().strengths;
  for (std::size_t i = 1; i < steel->sources.size(); ++i)
    lower = lower_of(lower, steel->sources[i].strengths);
  lower.name = name;
  return lower;
}

std::optional<Material> find_steel(const std::string& name, const std::string& source) {
  const Steel* steel = steel_named(name);
  if (steel == nullptr) return std::nullopt;
  for (const Steel::Source& of : steel->sources) {
    if (of.name != source) continue;
    Material material = of.strengths;
    material.name = name;
    return material;
  }
  return std::nullopt;
}

std::vector<std::string> steel_names() {
  std::vector<std::string> names;
  for (const Steel& steel : steels()) names.push_back(steel.names.front());
  return names;
}

const std::vector<std::string>& steel_sources() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const SourceName& source : sources) all.emplace_back(source.name);
    return all;
  }();
  return names;
}

std::vector<std::string> sources_of_steel(const std::string& name) {
  std::vector<std::string> names;
  if (const Steel* steel = steel_named(name)) {
    for (const Steel::Source& source : steel->sources) names.push_back(source.name);
  }
  return names;
}

}  // namespace boxbeam
