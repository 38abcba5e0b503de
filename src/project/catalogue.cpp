#include "boxbeam/project/catalogue.hpp"

#include <cassert>

#include "boxbeam/project/case_document.hpp"
#include "boxbeam/project/table_reader.hpp"
#include "catalogue_data.hpp"

namespace boxbeam {
namespace {

std::vector<Material> read_steels() {
  const CaseDocument document = parse_document("steels.toml", catalogue_data::steels, {});
  ProblemList problems(document);
  std::vector<Material> steels;
  for (auto& [name, table] : TableReader(problems, document.root, "").named_tables()) {
    Material steel{name, table.text("source"), {}};
    const std::vector<double> up_to = table.quantities("up_to", wanted::length);
    const std::vector<double> yield = table.quantities("yield", wanted::stress);
    assert(up_to.size() == yield.size());
    for (std::size_t i = 0; i < up_to.size(); ++i) {
      steel.yield.push_back({si<Length>(up_to[i]), si<Stress>(yield[i])});
    }
    table.finish();
    steels.push_back(std::move(steel));
  }
  problems.raise();
  return steels;
}

const std::vector<Material>& steels() {
  static const std::vector<Material> all = read_steels();
  return all;
}

}  // namespace

std::optional<Material> find_steel(const std::string& name) {
  for (const Material& steel : steels()) {
    if (steel.name == name) return steel;
  }
  return std::nullopt;
}

std::vector<std::string> steel_names() {
  std::vector<std::string> names;
  for (const Material& steel : steels()) names.push_back(steel.name);
  return names;
}

}  // namespace boxbeam
