// What holds for every row of the tables of details, and how facts raise a category.

#include "boxbeam/project/detail_catalogue.hpp"

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "boxbeam/project/sn_catalogue.hpp"
#include "catch.hpp"
#include "project/detail_facts.hpp"

namespace detail_catalogue_test {

using namespace boxbeam;
using namespace detail_facts;

namespace {

constexpr StressKind kinds[] = {StressKind::direct, StressKind::shear};

/// Limits of the ranges in all rows, and values beside them, by fact.
std::map<std::string, std::vector<double>> numbers_of_interest() {
  std::map<std::string, std::vector<double>> numbers;
  for (const DetailRow& row : detail_rows()) {
    for (const auto& [fact, allowed] : row.conditions) {
      const auto* range = std::get_if<FactRange>(&allowed);
      if (range == nullptr) continue;
      for (const double limit : {range->from, range->to}) {
        if (!std::isfinite(limit)) continue;
        for (const double factor : {0.9, 1.0, 1.1}) numbers[fact].push_back(factor * limit);
      }
    }
  }
  return numbers;
}

/// Random facts; the generator is seeded by the caller.
Facts random_facts(std::mt19937& random, double share_known) {
  static const auto numbers = numbers_of_interest();
  std::bernoulli_distribution known(share_known);
  const auto pick = [&](const auto& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random)];
  };
  Facts facts;
  for (const FactDefinition& fact : fact_definitions()) {
    if (!known(random)) continue;
    if (fact.kind == FactDefinition::Kind::words) {
      facts.emplace(fact.name, pick(fact.words));
    } else if (const auto found = numbers.find(fact.name); found != numbers.end()) {
      facts.emplace(fact.name, pick(found->second));
    }
  }
  return facts;
}

/// Facts that a row asks for, one value each.
Facts facts_of(const DetailRow& row) {
  Facts facts;
  for (const auto& [fact, allowed] : row.conditions) {
    if (const auto* words = std::get_if<Words>(&allowed)) {
      facts.emplace(fact, words->front());
      continue;
    }
    const auto& range = std::get<FactRange>(allowed);
    if (!std::isfinite(range.to)) {
      facts.emplace(fact, 1.5 * range.from);
    } else {
      facts.emplace(fact,
                    std::isfinite(range.from) ? 0.5 * (range.from + range.to) : 0.9 * range.to);
    }
  }
  return facts;
}

std::set<const void*> members(const std::vector<DetailRow>& found) {
  // Entries of one row are told apart by their place in the catalogue.
  std::set<const void*> places;
  for (const DetailRow& row : found) {
    const auto same = std::find_if(detail_rows().begin(), detail_rows().end(), [&](auto& other) {
      return other.id == row.id && other.what == row.what && other.kind == row.kind &&
             other.conditions == row.conditions;
    });
    places.insert(&*same);
  }
  return places;
}

}  // namespace

TEST_CASE("rows read one by one are those of the whole table") {
  std::set<std::string> ids;
  for (const DetailRow& row : detail_rows()) ids.insert(row.id);
  CHECK(ids.size() > 90);
  for (const std::string& id : ids) {
    std::vector<DetailRow> wanted;
    std::copy_if(detail_rows().begin(), detail_rows().end(), std::back_inserter(wanted),
                 [&](const DetailRow& row) { return row.id == id; });
    const std::vector<DetailRow> found = detail_rows_of(id);
    REQUIRE(found.size() == wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      CHECK(found[i].what == wanted[i].what);
      CHECK(found[i].category == wanted[i].category);
      CHECK(found[i].conditions.size() == wanted[i].conditions.size());
    }
  }
  CHECK(detail_rows_of("8.10").empty());
  CHECK(detail_rows_of("8.1").empty());
}

TEST_CASE("every row of the tables of details is sound", "[detail_catalogue]") {
  CHECK(detail_rows().size() > 100);
  for (const DetailRow& row : detail_rows()) {
    CAPTURE(row.id, row.category, row.what);
    CHECK(row.id.find('/') != std::string::npos);
    CHECK_FALSE(row.what.empty());
    CHECK(row.conditions.contains("part"));
    CHECK(row.conditions.contains("stress"));
    // Table 8.1 is of details without welds, and no other.
    CHECK(row.welded == !(row.id.starts_with("8.1/") || row.id == "8.10/1"));
    CHECK((row.where == StressPlace::hot_spot) == row.id.starts_with("B.1/"));
    CHECK((row.size_effect == SizeEffect::butt || row.size_effect == SizeEffect::eccentric_butt) ==
          (row.id.starts_with("8.3/") && row.id != "8.3/18" && row.id != "8.3/19"));
    // Lattice nodes and studs have a line without bend; what has a stress of no section says so.
    CHECK(row.slope == (row.id.starts_with("8.7/") ? 5.0 : row.id == "8.5/10" ? 8.0 : 0.0));
    CHECK(row.endless == (row.id == "8.5/10"));
    CHECK((std::get<Words>(row.conditions.at("stress")) == Words{"local"}) ==
          (row.id.starts_with("8.10/") || row.id == "8.5/10" || row.id == "8.8/6" ||
           row.id == "8.8/7" || row.id == "8.8/8" || row.id == "8.9/2"));
    if (row.interpolation) {
      CHECK(row.interpolation->from == row.category);
      const auto& range = std::get<FactRange>(row.conditions.at(row.interpolation->fact));
      CHECK(std::isfinite(range.from));
      CHECK(std::isfinite(range.to));
    }
    // Its category is a curve of the code, raised or not.
    CHECK(curve_of(row).reference.value() * 1e-6 == Approx(row.category));
    CHECK(curve_of(row).kind == row.kind);
    if (row.asterisk) CHECK(curve_of(row, true).reference > curve_of(row).reference);
  }
}

TEST_CASE("every row is reached by its own facts, and governs but where lines overlap",
          "[detail_catalogue]") {
  for (const DetailRow& row : detail_rows()) {
    CAPTURE(row.id, row.category, row.what);
    const auto found = about(facts_of(row), row.kind).candidates;
    REQUIRE_FALSE(found.empty());
    CHECK(members(found).contains(&row));
    CHECK(std::min_element(found.begin(), found.end(),
                           [](auto& a, auto& b) { return a.category < b.category; })
              ->category == (row.id == "8.4/4" || row.id == "8.3/19" ? found.front().category
                             : row.interpolation
                                 ? 0.5 * (row.interpolation->from + row.interpolation->to)
                                 : row.category));
  }
}

TEST_CASE("more facts never add rows, and less known never gives a higher category",
          "[detail_catalogue]") {
  std::mt19937 random(20051993);
  int alive = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    // Begin from a row's own facts half of the time, so that some row fits.
    Facts facts = random_facts(random, 0.15);
    if (trial % 2 == 0) {
      const std::size_t i =
          std::uniform_int_distribution<std::size_t>(0, detail_rows().size() - 1)(random);
      facts = with(facts, facts_of(detail_rows()[i]));
    }
    for (const StressKind kind : kinds) {
      const auto all = about(facts, kind).candidates;
      if (all.empty()) continue;
      ++alive;
      for (const auto& [name, value] : facts) {
        Facts fewer = facts;
        fewer.erase(name);
        const auto more = about(fewer, kind).candidates;
        CAPTURE(name);
        const auto before = members(all);
        const auto after = members(more);
        CHECK(std::includes(after.begin(), after.end(), before.begin(), before.end()));
        CHECK(more.front().category <= all.front().category);
      }
    }
  }
  CHECK(alive > 500);
}

TEST_CASE("only deciding facts can raise what governs", "[detail_catalogue]") {
  std::mt19937 random(1049);
  int decided = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const std::size_t i =
        std::uniform_int_distribution<std::size_t>(0, detail_rows().size() - 1)(random);
    Facts facts = facts_of(detail_rows()[i]);
    std::erase_if(facts, [&](auto&) { return std::bernoulli_distribution(0.4)(random); });
    const StressKind kind = detail_rows()[i].kind;
    const DetailAssessment before = about(facts, kind);
    REQUIRE_FALSE(before.candidates.empty());
    decided += before.deciding.empty() ? 1 : 0;
    Facts more = random_facts(random, 0.5);
    // A thickness also changes the size effect.
    more.erase("thickness");
    for (const std::string& fact : before.deciding) more.erase(fact);
    const auto after = about(with(more, facts), kind).candidates;
    if (after.empty()) continue;
    CHECK(after.front().category == before.candidates.front().category);
  }
  CHECK(decided > 100);
}

TEST_CASE("a raise holds: with its changes its row governs, and what the detail is stays",
          "[detail_catalogue]") {
  std::mt19937 random(8529);
  int raised = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const std::size_t i =
        std::uniform_int_distribution<std::size_t>(0, detail_rows().size() - 1)(random);
    Facts facts = facts_of(detail_rows()[i]);
    // Forget some.
    std::erase_if(facts, [&](auto&) { return std::bernoulli_distribution(0.2)(random); });
    const auto found = about(facts, detail_rows()[i].kind).candidates;
    REQUIRE_FALSE(found.empty());
    for (const Raise& raise : raises_of(detail_rows(), found, facts, fixed_facts())) {
      ++raised;
      CHECK(raise.changes.size() <= Raise::most_changes);
      Facts changed = facts;
      for (const FactChange& change : raise.changes) {
        CHECK_FALSE([&] {
          const Words fixed = fixed_facts();
          return std::find(fixed.begin(), fixed.end(), change.fact) != fixed.end();
        }());
        changed.insert_or_assign(change.fact, facts_of(raise.row).at(change.fact));
      }
      const auto strength = [](const Facts& known, StressKind kind) {
        const DetailRow weakest = about(known, kind).candidates.front();
        return weakest.category * size_factor_of(weakest, known).value_or(1.0);
      };
      CHECK(strength(changed, raise.row.kind) > strength(facts, raise.row.kind));
    }
  }
  CHECK(raised > 500);
}

TEST_CASE("partial factors, table 3.1", "[detail_catalogue]") {
  CHECK(recommended_gamma_Mf(AssessmentMethod::damage_tolerant, Consequence::low) == 1.00);
  CHECK(recommended_gamma_Mf(AssessmentMethod::damage_tolerant, Consequence::high) == 1.15);
  CHECK(recommended_gamma_Mf(AssessmentMethod::safe_life, Consequence::low) == 1.15);
  CHECK(recommended_gamma_Mf(AssessmentMethod::safe_life, Consequence::high) == 1.35);
}

TEST_CASE("changes read as a designer would say them", "[detail_catalogue]") {
  CHECK(to_text(FactChange{"weld", Words{"butt", "fillet"}}) == "weld = butt or fillet");
  CHECK(to_text(FactChange{"attachment_length", FactRange{.to = 0.05}}) ==
        "attachment_length up to 50 mm");
  CHECK(to_text(FactChange{"thickness", FactRange{.from = 0.02, .to = 0.03, .with_from = false}}) ==
        "thickness over 20 mm up to 30 mm");
  CHECK(to_text(FactChange{"convexity", FactRange{.to = 0.1, .with_to = false}}) ==
        "convexity under 0.1");
}

}  // namespace detail_catalogue_test
