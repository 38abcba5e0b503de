// What the reader asks for while it reads the cases with every key: schema and reference of the
// keys are written from it (tests/whole/case_schema.py compares the schema with the reader).

#include "boxbeam/project/key_reference.hpp"

#include <algorithm>
#include <fstream>
#include <set>

#include "boxbeam/report/case_schema.hpp"
#include "catch.hpp"
#include "support/program.hpp"
#include "template_data.hpp"

namespace key_reference_test {

using namespace boxbeam;

const TableDescription& table_of(const std::string& kind, const std::string& pattern) {
  const auto& reference = key_reference_of(kind);
  const auto found = std::find_if(reference.begin(), reference.end(),
                                  [&](const auto& each) { return each.pattern == pattern; });
  REQUIRE(found != reference.end());
  return *found;
}

const KeyDescription& key_of(const TableDescription& table, const std::string& name) {
  const auto found = std::find_if(table.keys.begin(), table.keys.end(),
                                  [&](const auto& each) { return each.key.name == name; });
  REQUIRE(found != table.keys.end());
  return *found;
}

TEST_CASE("every word that decides which keys a table has stands in an example") {
  for (const std::string& kind : case_kinds()) {
    KeyRecorder recorder;
    for (const auto& example : template_data::examples) {
      if (kind == example.kind) record_keys(example.name, example.text, recorder);
    }
    std::set<std::string> missing;
    std::set<std::string> there;
    for (const TableVisit& visit : recorder.visits()) {
      for (const auto& [key, word] : visit.choices) {
        there.insert(visit.pattern + "." + key + " = " + word);
        for (const std::string& other : visit.find(key)->words)
          missing.insert(visit.pattern + "." + key + " = " + other);
      }
    }
    for (const std::string& each : there) missing.erase(each);
    CAPTURE(kind);
    CHECK(missing == std::set<std::string>{});
  }
}

TEST_CASE("every key has a kind of value and a meaning") {
  for (const std::string& kind : case_kinds()) {
    for (const TableDescription& table : key_reference_of(kind)) {
      for (const KeyDescription& of : table.keys) {
        if (of.key.name == "*") continue;
        INFO(kind << " " << table.pattern << " " << of.key.name);
        CHECK(of.key.shape != KeyShape::unknown);
        CHECK_FALSE(of.key.meaning.empty());
      }
    }
  }
}

TEST_CASE("a key is known where its reader asks for it, required where nothing may stand instead") {
  const TableDescription& sections = table_of("planar", "sections.*");
  const KeyDescription& width = key_of(sections, "width");
  CHECK(width.key.shape == KeyShape::positive);
  CHECK(width.key.required);
  CHECK(width.only == std::vector<KeyDescription::Only>{{"kind", {"box"}}});
  CHECK(key_of(sections, "wall").only ==
        std::vector<KeyDescription::Only>{{"kind", {"rectangular tube", "round tube"}}});
  CHECK_FALSE(key_of(sections, "flange").key.required);
  const KeyWays plates{{{"top_flange", "bottom_flange"}}, {{"flange"}}};
  CHECK(std::any_of(sections.ways.begin(), sections.ways.end(),
                    [&](const WaysDescription& each) { return each.ways == plates; }));
  const KeyDescription& tolerance = key_of(table_of("flexible", "model"), "tolerance");
  CHECK_FALSE(tolerance.key.required);
  CHECK(tolerance.key.fallback == "0.01");
  const KeyDescription& modulus = key_of(table_of("planar", "model"), "youngs_modulus");
  CHECK(modulus.key.fallback == "\"210000 MPa\"");
}

TEST_CASE("docs/keys.md is what the program writes") {
  CHECK(test::read_file(test::project_file("docs/keys.md")) == schema_of("keys"));
}

}  // namespace key_reference_test
