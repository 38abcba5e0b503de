#include "boxbeam/fatigue/detail.hpp"

#include <algorithm>

#include "catch.hpp"

namespace detail_test {

using namespace boxbeam;

namespace {

using Words = std::vector<std::string>;

DetailRow row(const char* id, double category,
              std::map<std::string, Allowed, std::less<>> conditions) {
  DetailRow made;
  made.id = id;
  made.category = category;
  made.conditions = std::move(conditions);
  return made;
}

/// A small table of our own: a weld by its process, an attachment by its length with a gap and an
/// overlap at 50 mm.
std::vector<DetailRow> small_table() {
  return {
      row("1", 125,
          {{"part", Words{"seam"}}, {"process", Words{"automatic"}}, {"stop_start", Words{"no"}}}),
      row("2", 112,
          {{"part", Words{"seam"}}, {"process", Words{"automatic"}}, {"stop_start", Words{"yes"}}}),
      row("3", 100, {{"part", Words{"seam"}}, {"process", Words{"manual"}}}),
      row("4", 80, {{"part", Words{"attachment"}}, {"length", FactRange{.to = 0.05}}}),
      row("5", 71,
          {{"part", Words{"attachment"}}, {"length", FactRange{.from = 0.05, .to = 0.08}}}),
      row("6", 63,
          {{"part", Words{"attachment"}},
           {"length", FactRange{.from = 0.08, .with_from = false}}})};
}

Words ids_of(const std::vector<DetailRow>& rows) {
  Words ids;
  for (const DetailRow& each : rows) ids.push_back(each.id);
  return ids;
}

Words candidates(const Facts& facts) {
  return ids_of(assess(small_table(), StressKind::direct, facts).candidates);
}

}  // namespace

TEST_CASE("a range of a fact has its ends or not", "[detail]") {
  const Allowed closed = FactRange{.from = 1.0, .to = 2.0};
  const Allowed open = FactRange{.from = 1.0, .to = 2.0, .with_from = false, .with_to = false};
  for (const double end : {1.0, 2.0}) {
    CHECK(allows(closed, end));
    CHECK_FALSE(allows(open, end));
    CHECK(allows(closed, end * (1 + 1e-15)));  // a bit of round-off
    CHECK_FALSE(allows(open, end * (1 - 1e-15)));
  }
  CHECK(allows(open, 1.5));
  CHECK_FALSE(allows(closed, 0.99));
  CHECK_FALSE(allows(closed, 2.01));
  CHECK(allows(FactRange{}, -1e9));
}

TEST_CASE("what is not known excludes nothing, and the weakest row governs", "[detail]") {
  CHECK(candidates({{"part", "seam"}}) == Words{"3", "2", "1"});
  CHECK(candidates({{"part", "seam"}, {"process", "automatic"}}) == Words{"2", "1"});
  CHECK(candidates({{"part", "seam"}, {"stop_start", "no"}}) == Words{"3", "1"});
  CHECK(candidates({}).front() == "6");
  CHECK(candidates({{"part", "bolt"}}).empty());
}

TEST_CASE("where two lines of a table meet, the weaker of both governs", "[detail]") {
  CHECK(candidates({{"part", "attachment"}, {"length", 0.05}}) == Words{"5", "4"});
  CHECK(candidates({{"part", "attachment"}, {"length", 0.08}}) == Words{"5"});
  CHECK(candidates({{"part", "attachment"}, {"length", 0.0800001}}) == Words{"6"});
}

TEST_CASE("deciding facts are those that can exclude what governs and leave stronger rows",
          "[detail]") {
  const auto deciding = [](const Facts& facts) {
    return assess(small_table(), StressKind::direct, facts).deciding;
  };
  CHECK(deciding({{"part", "seam"}}) == Words{"process"});
  CHECK(deciding({{"part", "seam"}, {"process", "automatic"}}) == Words{"stop_start"});
  CHECK(deciding({{"part", "seam"}, {"process", "manual"}}).empty());
  CHECK(deciding({{"part", "attachment"}}) == Words{"length"});
  CHECK(deciding({{"part", "attachment"}, {"length", 0.05}}).empty());
}

TEST_CASE("raises name the facts to know or to change, fewest first, and they hold", "[detail]") {
  const std::vector<DetailRow> rows = small_table();
  const Facts facts{{"part", "seam"}, {"process", "automatic"}, {"stop_start", "yes"}};
  const auto raises = raises_of(rows, {rows[1]}, facts, {"part"});
  REQUIRE(raises.size() == 1);
  CHECK(raises[0].row.id == "1");
  CHECK(raises[0].changes == std::vector<FactChange>{{"stop_start", Words{"no"}}});

  // From a manual weld with unknown stops: automatic alone leaves row 2, which is stronger too only
  // once its stops are known.
  const auto more = raises_of(rows, {rows[2]}, {{"part", "seam"}, {"process", "manual"}}, {"part"});
  REQUIRE(more.size() == 2);
  CHECK(more[0].row.id == "1");
  CHECK(more[0].changes.size() == 2);
  CHECK(more[1].row.id == "2");

  // What the detail is stays.
  CHECK(raises_of(rows, {rows[2]}, {{"part", "seam"}, {"process", "manual"}}, {"part", "process"})
            .empty());
  CHECK(raises_of(rows, {rows[0]}, {{"part", "seam"}}, {"part"}).empty());
}

TEST_CASE("a row of the other kind of stress is no candidate", "[detail]") {
  std::vector<DetailRow> rows = small_table();
  rows[2].kind = StressKind::shear;
  CHECK(ids_of(assess(rows, StressKind::direct, {{"part", "seam"}}).candidates) == Words{"2", "1"});
  CHECK(ids_of(assess(rows, StressKind::shear, {{"part", "seam"}}).candidates) == Words{"3"});
}

TEST_CASE("with the size effect a row of a higher category may be the weakest", "[detail]") {
  std::vector<DetailRow> rows{row("thick", 80, {}), row("plain", 71, {})};
  rows[0].size_effect = SizeEffect::butt;
  const auto first = [&](const Facts& facts) {
    return assess(rows, StressKind::direct, facts).candidates.front().id;
  };
  CHECK(first({}) == "plain");
  CHECK(first({{"thickness", 0.040}}) == "plain");  // 80 * 0.9103 = 72.8
  CHECK(first({{"thickness", 0.060}}) == "thick");  // 80 * 0.8394 = 67.2
}

TEST_CASE("the size factor of a row wants its own lengths", "[detail]") {
  DetailRow any = row("x", 100, {});
  CHECK(size_factor_of(any, {}) == 1.0);
  any.size_effect = SizeEffect::butt;
  CHECK_FALSE(size_factor_of(any, {{"bolt_diameter", 0.04}}));
  CHECK(size_factor_of(any, {{"thickness", 0.060}}).value() == Approx(0.8394).margin(5e-5));
  any.size_effect = SizeEffect::bolt;
  CHECK_FALSE(size_factor_of(any, {{"thickness", 0.060}}));
  CHECK(size_factor_of(any, {{"bolt_diameter", 0.480}}).value() == Approx(0.5));
  any.size_effect = SizeEffect::eccentric_butt;
  CHECK_FALSE(size_factor_of(any, {{"thickness", 0.020}, {"eccentricity", 0.005}}));
  CHECK(size_factor_of(
            any, {{"thickness", 0.020}, {"thicker_thickness", 0.030}, {"eccentricity", 0.005}})
            .value() == Approx(0.65415).margin(5e-6));
}

TEST_CASE("the category of a row with an asterisk has it in its name", "[detail]") {
  DetailRow weld = row("8.5/3", 36, {});
  CHECK(category_name_of(weld) == "36");
  weld.asterisk = true;
  CHECK(category_name_of(weld) == "36*");
}

}  // namespace detail_test
