#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "boxbeam/project/signal_file.hpp"
#include "catch.hpp"
#include "project/signals/written_table.hpp"
#include "support/program.hpp"
#include "support/property.hpp"

namespace csv_signals_test {

using namespace boxbeam;

namespace {

SignalTable read_text(const std::string& text, const std::vector<WantedSignal>& wanted = {}) {
  const test::TemporaryFolder folder;
  return read_signal_file({folder.write("signals.csv", text)}, wanted);
}

std::vector<double> values_of(const SignalColumn& column) {
  std::vector<double> values;
  for (std::size_t i = 0; i < column.size(); ++i) values.push_back(column[i]);
  return values;
}

}  // namespace

TEST_CASE("a table says the same however it is written") {
  test::holds(
      [] {
        using Units = test::Writing::Units;
        using Encoding = test::Writing::Encoding;
        test::Writing way;
        way.separator = *rc::gen::element(',', ';', '\t', ' ');
        way.decimal_sign = way.separator == ',' ? '.' : *rc::gen::element('.', ',');
        way.units = *rc::gen::element(Units::brackets, Units::parentheses, Units::row);
        way.quotes = *rc::gen::arbitrary<bool>();
        way.line_end = *rc::gen::element<std::string>("\n", "\r\n", "\r");
        way.encoding = *rc::gen::element(Encoding::utf8, Encoding::utf8_mark, Encoding::latin1,
                                         Encoding::utf16_little, Encoding::utf16_big,
                                         Encoding::utf16_unmarked);
        const auto columns = *rc::gen::inRange<std::size_t>(1, 6);
        const auto rows = *rc::gen::inRange<std::size_t>(1, 30);
        test::WrittenTable table{{"time"}, {"s"}, {}};
        for (std::size_t k = 0; k < columns; ++k) {
          table.names.push_back(fmt::format("Kr\u00e4fte{}", k));
          table.units.push_back(k % 2 == 0 ? "kN" : "N\u00b7m");
        }
        double time = 0.0;
        for (std::size_t i = 0; i < rows; ++i) {
          time += 0.001 * *rc::gen::inRange(1, 5000);
          std::vector<double> row{time};
          for (std::size_t k = 0; k < columns; ++k) {
            row.push_back(std::ldexp(*rc::gen::inRange(-1'000'000'000, 1'000'000'000),
                                     *rc::gen::inRange(-40, 20)));
          }
          table.rows.push_back(row);
        }

        const SignalTable read = read_text(test::text_of(table, way));
        RC_ASSERT(read.time.count == rows);
        RC_ASSERT(read.names ==
                  std::vector<std::string>(table.names.begin() + 1, table.names.end()));
        RC_ASSERT(read.units ==
                  std::vector<std::string>(table.units.begin() + 1, table.units.end()));
        for (std::size_t i = 0; i < rows; ++i) {
          RC_ASSERT(read.time[i] == table.rows[i][0]);
          for (std::size_t k = 0; k < columns; ++k) {
            RC_ASSERT(read.columns[k][i] == table.rows[i][k + 1]);
          }
        }
      },
      300);
}

TEST_CASE("columns may stand in any order, and be wanted in any order") {
  test::holds([] {
    const std::size_t columns = 5;
    test::WrittenTable table{{"time"}, {"s"}, {}};
    for (std::size_t k = 1; k < columns; ++k) {
      table.names.push_back(fmt::format("F{}", k));
      table.units.push_back("kN");
    }
    for (int i = 0; i < 7; ++i) {
      table.rows.push_back({0.5 * i, *rc::gen::inRange(-99, 99) / 8.0, 2.0, 3.0 * i, -4.0 * i});
    }
    std::vector<std::size_t> order(columns);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t k = columns; k-- > 1;) {
      std::swap(order[k], order[*rc::gen::inRange<std::size_t>(0, k + 1)]);
    }
    test::WrittenTable permuted{{}, {}, std::vector<std::vector<double>>(table.rows.size())};
    for (const std::size_t k : order) {
      permuted.names.push_back(table.names[k]);
      permuted.units.push_back(table.units[k]);
      for (std::size_t i = 0; i < table.rows.size(); ++i) {
        permuted.rows[i].push_back(table.rows[i][k]);
      }
    }
    std::vector<WantedSignal> wanted;
    for (const std::size_t k : order) {
      if (k > 0) wanted.push_back({table.names[k], wanted::force});
    }
    const SignalTable plain = read_text(test::text_of(table, {}), wanted);
    const SignalTable other = read_text(test::text_of(permuted, {}), wanted);
    RC_ASSERT(plain.names == other.names);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      RC_ASSERT(values_of(plain.columns[k]) == values_of(other.columns[k]));
    }
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
      RC_ASSERT(other.time[i] == table.rows[i][0]);
    }
  });
}

TEST_CASE("a head of the SAE gives the time step, or says that the first column is the time") {
  const SignalTable steps = read_text("#SAE test\n#TIMEstep= 120 Seconds\n1.5\n2.5\n-3\n");
  CHECK(steps.names == std::vector<std::string>{"column 1"});
  CHECK(steps.time[2] == 240.0);
  CHECK(values_of(steps.columns[0]) == std::vector<double>{1.5, 2.5, -3});
  const SignalTable timed = read_text("#TIMEstep= 0\nseconds, load\n0.5, 1\n2, 4\n");
  CHECK(timed.time[1] == 2.0);
  CHECK(timed.names == std::vector<std::string>{"load"});
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "load [kN]\n1\n2\n");
  CHECK(read_signal_file({path, {}, 0.25}).time[1] == 0.25);
}

TEST_CASE("a column called T is a torsional moment, however small its name") {
  const test::TemporaryFolder folder;
  const std::string path = folder.write("a.csv", "N [kN],T [kN m]\n1,2\n3,4\n");
  CHECK(list_signals({path, {}, 0.1}).channels.size() == 2);
  CHECK(read_text("T [kN m],t [s]\n1,2\n3,4\n").time[1] == 4.0);
}

TEST_CASE("units are those of the field, in the ways in which programs write them") {
  struct Row {
    const char* unit;
    WantedDimension dimension;
    double factor;  ///< by its definition
  };
  const double degree = std::numbers::pi / 180.0;
  for (const Row& row :
       {Row{"kN-m", wanted::moment, 1e3}, Row{"kNm", wanted::moment, 1e3},
        Row{"N*mm", wanted::moment, 1e-3}, Row{"Newton-meter", wanted::moment, 1.0},
        Row{"N\u00b7m", wanted::moment, 1.0}, Row{"MN m", wanted::moment, 1e6},
        Row{"mm/s**2", wanted::acceleration, 1e-3}, Row{"m/sec^2", wanted::acceleration, 1.0},
        Row{"newton", wanted::force, 1.0}, Row{"deg", wanted::angle, degree},
        Row{"\u00b0", wanted::angle, degree}, Row{"1/s", wanted::frequency, 1.0},
        Row{"-", wanted::pure_number, 1.0}, Row{"MPa", wanted::stress, 1e6},
        Row{"N/mm^2", wanted::stress, 1e6}}) {
    INFO(row.unit);
    const SignalTable table =
        read_text(fmt::format("time [s], x [{}]\n0, 2\n", row.unit), {{"x", row.dimension}});
    CHECK(table.columns[0][0] == Approx(2.0 * row.factor).epsilon(1e-14));
  }
  const SignalTable late = read_text("time [min], x [kN]\n0, 2\n1.5, 3\n");
  CHECK(late.time[1] == 90.0);
  CHECK(late.columns[0][1] == 3.0);  // no dimension is wanted: the file's unit
  CHECK(read_text("t;F\nms;kN\n0;2\n500;3\n").time[1] == 0.5);
}

TEST_CASE("the comments, blank lines and quoted names of a table do not count") {
  const SignalTable table = read_text(
      "# rig 7\n\n\"time [s]\" , \"force, left #2 [kN]\" # gauges\n\n 0 , \"1.5\" # first\n"
      "# nothing\n\n+1,-2.25\n");
  CHECK(table.names == std::vector<std::string>{"force, left #2"});
  CHECK(values_of(table.columns[0]) == std::vector<double>{1.5, -2.25});
  // With a row of units, brackets are part of the names.
  CHECK(read_text("t;F (left)\ns;kN\n0;1\n").names == std::vector<std::string>{"F (left)"});
  CHECK(read_text("t [s] \"F left\" [kN]\n0 1\n").names == std::vector<std::string>{"F left"});
}

}  // namespace csv_signals_test
