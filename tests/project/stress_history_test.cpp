#include "boxbeam/project/stress_history.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <vector>

#include "catch.hpp"
#include "support/program.hpp"
#include "support/property.hpp"

namespace stress_history_test {

using namespace boxbeam;

namespace {

using Numbers = std::vector<double>;

struct Read {
  Numbers normal, shear;
  StressHistory history;
};

Read read(const StressHistorySource& source) {
  Read result;
  result.history = read_stress_history(source, [&](const StressSamples& samples) {
    result.normal.insert(result.normal.end(), samples.normal.begin(), samples.normal.end());
    result.shear.insert(result.shear.end(), samples.shear.begin(), samples.shear.end());
  });
  CHECK(result.history.samples == result.normal.size());
  return result;
}

Read read_text(const std::string& text) {
  const test::TemporaryFolder folder;
  return read({folder.write("history.csv", text), std::nullopt});
}

std::string bytes_of(const Numbers& numbers) {
  std::string bytes;
  for (const double number : numbers) {
    const auto bits = std::bit_cast<std::uint64_t>(number);
    for (unsigned i = 0; i < 8; ++i) bytes += static_cast<char>((bits >> (8 * i)) & 0xFFU);
  }
  return bytes;
}

/// What the standard library reads, which rounds exactly.
double exactly(const std::string& text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  REQUIRE(result.ptr == text.data() + text.size());
  return value;
}

}  // namespace

TEST_CASE("one column of stresses in its unit") {
  CHECK(read_text("sigma [Pa]\n0\n-12.5\n3e2\n").normal == Numbers{0, -12.5, 300});
  CHECK(read_text("sigma [MPa]\n0.5\n").normal == Numbers{0.5e6});
  CHECK(read_text("sigma [kPa]\n2\n").normal == Numbers{2e3});
  CHECK(read_text("sigma [GPa]\n2\n").normal == Numbers{2e9});
  CHECK(read_text("sigma [N/mm^2]\n2\n").normal.front() == Approx(2e6).epsilon(1e-15));
  CHECK_FALSE(read_text("sigma [MPa]\n1\n").history.has_shear);
  CHECK_FALSE(read_text("sigma [MPa]\n1\n").history.first_time);
}

TEST_CASE("two columns of stresses are normal and shear") {
  const Read both = read_text("sigma [MPa], tau [Pa]\n1, 2\n3, 4\n");
  CHECK(both.normal == Numbers{1e6, 3e6});
  CHECK(both.shear == Numbers{2, 4});
  CHECK(both.history.has_shear);
}

TEST_CASE("the time before the stresses is checked and not handed on") {
  const Read timed = read_text("t [ms], sigma [Pa], tau [Pa]\n-500, 1, 2\n0, 3, 4\n1500, 5, 6\n");
  CHECK(timed.normal == Numbers{1, 3, 5});
  CHECK(timed.shear == Numbers{2, 4, 6});
  CHECK(timed.history.first_time == -0.5);
  CHECK(timed.history.last_time == 1.5);
}

TEST_CASE("commas, tabs and semicolons between columns, with semicolons a decimal comma") {
  const Numbers normal{1.5, -2.25};
  for (const char* text :
       {"t [s],sigma [Pa]\n0,1.5\n1,-2.25\n", "t [s]\tsigma [Pa]\n0\t1.5\n1\t-2.25\n",
        "t [s];sigma [Pa]\n0;1.5\n1;-2.25\n", "t [s] ; sigma [Pa]\n 0 ; 1,5 \n1;\t-2,25\t\n",
        "t [s];sigma [Pa]\n0,0;1,5\n1e0;-2,2500000000000000000\n"}) {
    INFO(text);
    CHECK(read_text(text).normal == normal);
  }
}

TEST_CASE("names in quotation marks, a row of units, decimal commas between tabs, CR alone") {
  const Numbers normal{1.5, -2.25};
  for (const char* text :
       {"\"t [s]\",\"sigma, gauge #3 [Pa]\"\n0,1.5\n1,-2.25\n",
        "\"t [s]\";\"sigma [Pa]\"\n\"0\";\"1,5\"\n\"1\";\"-2,25\"\n",
        "time;sigma\ns;Pa\n0;1,5\n1;-2,25\n", "time\tsigma\n[s]\t[Pa]\n0\t1,5\n1\t-2,25\n",
        "\xEF\xBB\xBFsigma\n(Pa)\n1.5\n-2.25\n", "sigma [Pa]\r1.5\r-2.25\r",
        "sigma [Pa]\r1.5\r# last\r-2.25", "sigma [Pa]\r\n1.5\r\n-2.25"}) {
    INFO(text);
    CHECK(read_text(text).normal == normal);
  }
  // The line ends are those of the first line, however far the others are.
  std::string long_table = "sigma [Pa]\r";
  while (long_table.size() < (std::size_t{3} << 20U)) long_table += "1\r2\r";
  CHECK(read_text(long_table).history.samples == (long_table.size() - 11) / 2);
}

TEST_CASE("comments, blank lines, CR LF, a byte order mark and a last line without end") {
  const Numbers normal{1, 2, 3};
  for (const char* text :
       {"# rig 7\n\n sigma [Pa] # first gauge\n1\n\n2 # here\n  \n#\n3\n",
        "\xEF\xBB\xBFsigma [Pa]\r\n1\r\n\r\n2\r\n# \xC3\xA9\r\n3\r\n",
        "\xEF\xBB\xBF# x\nsigma [Pa]\n1\n2\n3", "sigma [Pa]\n +1 \n\t2\n3\r\n"}) {
    INFO(text);
    CHECK(read_text(text).normal == normal);
  }
  CHECK(read_text("t [s]\tsigma [Pa]\n0\t1\n\t\n1\t2\n").normal == Numbers{1, 2});
}

TEST_CASE("a table longer than a block and a chunk") {
  std::string text = "t [s], sigma [Pa]\n";
  Numbers normal;
  for (int i = 0; i < 200000; ++i) {
    normal.push_back((i * 7919) % 10007 - 5000);
    text += std::to_string(i) + ", " + std::to_string(static_cast<int>(normal.back())) + "\n";
  }
  REQUIRE(text.size() > (std::size_t{2} << 20U));
  const Read table = read_text(text);
  CHECK(table.normal == normal);
  CHECK(table.history.last_time == 199999.0);
  // A comment as long as two blocks would hold up nothing but memory; half a block is read.
  CHECK(read_text("sigma [Pa]\n1\n#" + std::string(std::size_t{1} << 19U, 'x') + "\n2\n").normal ==
        Numbers{1, 2});
}

TEST_CASE("raw doubles in a unit") {
  const test::TemporaryFolder folder;
  const Numbers numbers{1.5, -2.25, 0.1, 1e-300};
  CHECK(read({folder.write("raw.bin", bytes_of(numbers)), "Pa"}).normal == numbers);
  CHECK(read({folder.write("raw.bin", bytes_of({1.5})), "MPa"}).normal == Numbers{1.5e6});
  CHECK(bytes_of({1.0}) == std::string("\0\0\0\0\0\0\xF0\x3F", 8));  // IEEE 754, little-endian
  const Numbers many(100001, 7.0);
  CHECK(read({folder.write("raw.bin", bytes_of(many)), "Pa"}).normal == many);
}

TEST_CASE("numbers are rounded exactly") {
  for (const std::string text :
       {"0.1", "123.456", "9007199254740992", "9007199254740993", "9007199254740993.0",
        "0.9007199254740993", "1e20", "1e-22", "123e-25", "4.35", "2.2250738585072014e-308",
        "4.9e-324", "0.000000000000000000000123", "1e0000", "-7.0E+05", "99999999999999999999",
        "0.1000000000000000055511151231257827021181583404"}) {
    INFO(text);
    CHECK(read_text("sigma [Pa]\n" + text + "\n").normal == Numbers{exactly(text)});
  }
  test::holds([] {
    const auto digits = *rc::gen::arbitrary<std::uint64_t>();
    const auto kept = *rc::gen::inRange<std::size_t>(1, 20);
    const auto point = *rc::gen::inRange<std::size_t>(0, 20);
    const auto exponent = *rc::gen::inRange(-25, 4);
    std::string text = std::to_string(digits * 6364136223846793005U + 1442695040888963407U);
    text.resize(std::min(kept, text.size()));
    text.insert(std::min(point, text.size()), ".");
    text += "e" + std::to_string(exponent);
    const double value = exactly(text);
    RC_PRE(std::abs(value) <= 1e20);
    RC_ASSERT(read_text("sigma [Pa]\n-" + text + "\n").normal == Numbers{-value});
  });
}

}  // namespace stress_history_test
