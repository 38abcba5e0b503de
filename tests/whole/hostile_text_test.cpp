#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "catch.hpp"
#include "support/latex.hpp"
#include "support/program.hpp"

namespace hostile_text_test {

// What a user may write between quotation marks goes through every writer and comes out as written,
// and none of them takes it for markup of its own.

namespace {

namespace fs = std::filesystem;

/// Markup of HTML, LaTeX, gnuplot and the shell, quotes, and letters far from ASCII. Without the
/// full stop, which parts a body from its point.
const std::string hostile =
    R"(<script>alert(1)</script><!-- & &amp; "q" 'a' `id` \input{x} \n # $HOME % _i ^2 {/=50 b} ~ @| -- << )"
    "\xC3\xB8\xC5\x82\xC5\x91 \xCE\xA3\xCF\x83 \xC2\xB1\xE2\x89\xA4\xC2\xB2";
/// Not seen by any reader: a bell, an escape, a mark that turns the direction of writing.
const std::string unseen = "bell \x07 escape \x1b turn \xE2\x80\xAE end";
const std::string chinese = "\xE4\xB8\xAD";
const std::string long_word(90, 'W');

/// A text as a basic string of TOML 1.0, quotation marks included.
std::string toml_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += std::string("\\") + c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      out += c;
    }
  }
  return out + "\"";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  REQUIRE(text.find(what) != std::string::npos);
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// The shipped planar template with hostile names for everything that has one.
std::string hostile_case() {
  std::string text = test::read_file(test::project_file("sections/templates/planar.toml"));
  const auto quoted = [](const std::string& name) { return toml_string(name + " " + hostile); };
  const auto inner = [&](const std::string& name) {
    const std::string whole = quoted(name);
    return whole.substr(1, whole.size() - 2);
  };
  for (const char* body : {"crank", "rod", "lever", "load"}) {
    const std::string name = body;
    text =
        replaced(text, fmt::format("[bodies.{}]", name), fmt::format("[bodies.{}]", quoted(name)));
    text = replaced(text, fmt::format("\"{}.", name), fmt::format("\"{}.", inner(name)));
  }
  text = replaced(text, "body = \"lever\"", "body = " + quoted("lever"));
  for (const char* joint : {"O", "A", "B", "C", "D"}) {
    const std::string name = joint;
    text =
        replaced(text, fmt::format("[joints.{}]", name), fmt::format("[joints.{}]", quoted(name)));
  }
  text = replaced(text, "[drivers.motor]", "[drivers." + quoted("motor") + "]");
  text = replaced(text, "[loops.rod]", "[loops." + quoted("loop") + "]");
  for (const char* section : {"ends", "middle"}) {
    const std::string name = section;
    text = replaced(text, fmt::format("[sections.{}]", name),
                    fmt::format("[sections.{}]", quoted(name)));
    text = replaced(text, fmt::format("= \"{}\"", name), fmt::format("= {}", quoted(name)));
  }
  text = replaced(text, "name = \"lower\"", "name = " + quoted("lower"));
  text = replaced(text, "name = \"lug of the rod\"", "name = " + quoted("lug"));
  text = std::regex_replace(text, std::regex("assumed = \"[^\"]*\""), "assumed = \"@\"");
  text = replaced(text, "\"@\"", quoted("nobody"));
  text = std::regex_replace(text, std::regex("title = \"[^\"]*\""), "title = \"@\"");
  text = replaced(text, "title = \"@\"", "title = " + quoted("title"));
  text = replaced(text, "assumptions = [",
                  "assumptions = [\n" + toml_string(unseen) + ",\n" + toml_string(chinese) + ",\n" +
                      toml_string(long_word) + ",\n" + quoted("taken for granted") + ",");
  text = replaced(text, "cycles = 1e7 ", "# ");
  return text + "\n[[beam.holes]]\nname = " + quoted("hole") +
         "\ndiameter = \"40 mm\"\nstation = \"0.8 m\"\nlevels = [\"0 mm\"]\n"
         "through = \"webs\"\nconcentration = \"in-plane bending\"\n[[situations]]\nname = " +
         quoted("running") + "\ncycles = 1e7\n";
}

/// What a reader sees of XML: without its tags, its entities as the signs they are.
std::string shown(const std::string& xml) {
  std::string text;
  bool inside = false;
  for (const char c : xml) {
    if (c == '<') inside = true;
    if (!inside) text += c;
    if (c == '>') inside = false;
  }
  for (const auto& [entity, sign] : std::vector<std::pair<std::string, std::string>>{
           {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; at += sign.size())
      text.replace(at, entity.size(), sign);
  }
  return text;
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++times;
  return times;
}

}  // namespace

TEST_CASE("hostile text comes out of every writer as it was written", "[whole][hostile]") {
  const test::TemporaryFolder folder;
  const std::string case_file = folder.write("hostile.toml", hostile_case());
  const fs::path out = folder.path() / "out";
  const test::ProgramResult result =
      test::run_program({"verify", case_file, "--out", out.string()});
  INFO(result.out);
  INFO(result.err);
  REQUIRE((result.exit_code == 0 || result.exit_code == 1));

  const std::string named = "taken for granted " + hostile;
  SECTION("results.json") {
    const auto json = nlohmann::json::parse(test::read_file(out / "results.json"));
    std::string remarks;
    for (const auto& remark : json.at("remarks")) remarks += remark.get<std::string>() + "\n";
    CHECK(holds(remarks, named));
    CHECK(holds(remarks, unseen));
    CHECK(holds(remarks, long_word));
  }
  SECTION("text") {
    const std::string text = test::without_spaces(test::read_file(out / "report.txt"));
    CHECK(holds(text, test::without_spaces(named)));
    CHECK(holds(text, test::without_spaces("title " + hostile)));
    CHECK_FALSE(holds(text, "\x1b"));
  }
  SECTION("HTML") {
    const std::string html = test::read_file(out / "report.html");
    CHECK(holds(test::without_spaces(shown(html)), test::without_spaces(named)));
    CHECK_FALSE(holds(html, "<script>alert"));
    CHECK_FALSE(holds(html, "\x1b"));
    // The scripts and comments are those of any other report.
    const fs::path other = folder.path() / "other";
    test::run_program({"verify", test::project_file("sections/templates/planar.toml"), "--out",
                       other.string(), "--no-pdf"});
    const std::string clean = test::read_file(other / "report.html");
    CHECK(count(html, "<script") == count(clean, "<script"));
  }
  SECTION("figures") {
    std::string drawn;
    for (const fs::directory_entry& entry : fs::directory_iterator(out)) {
      if (entry.path().extension() == ".svg") drawn += shown(test::read_file(entry.path()));
    }
    CHECK(holds(test::without_spaces(drawn), test::without_spaces(hostile)));
  }
  SECTION("PDF") {
    REQUIRE(fs::exists(out / "report.pdf"));
    if (!test::has_pdftotext()) return;
    const std::string text = test::without_spaces(test::text_of_pdf((out / "report.pdf").string()));
    CHECK(holds(text, test::without_spaces(named)));
    CHECK(holds(text, "bell\\x07escape\\x1Bturn\\u202Eend"));
    CHECK(holds(text, "U+4E2D"));
    CHECK(holds(text, long_word));
  }
}

}  // namespace hostile_text_test
