#include "boxbeam/project/case_document.hpp"

#include "catch.hpp"

namespace case_document_test {

using namespace boxbeam;

namespace {

CaseDocument parse(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return parse_document("case.toml", text, overrides);
}

/// The one problem that parsing must end with.
Problem problem_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse(text, overrides);
  } catch (const InputError& error) {
    REQUIRE(error.problems().size() == 1);
    return error.problems().front();
  }
  FAIL("nothing was found wrong in: " << text.substr(0, 100));
  return {};
}

/// A node by its path from the root.
const Node& at(const CaseDocument& document, const std::vector<std::string>& path) {
  const Node* node = &document.root;
  for (const std::string& part : path) {
    node = node->find(part);
    REQUIRE(node != nullptr);
  }
  return *node;
}

const std::string small =
    "[beam]\n"
    "density = \"7800 kg/m^3\"\n"
    "\n"
    "[[beam.segments]]\n"
    "length = \"1.5 m\"\n"
    "[[beam.segments]]\n"
    "length = \"2 m\"\n";

}  // namespace

TEST_CASE("values keep their kind") {
  const CaseDocument document = parse(
      "text = \"1 m\"\nwhole = 3\nfraction = 3.0\nyes = true\nday = 2020-01-02\n"
      "list = [1, \"two\"]\n[table]\n");
  CHECK(at(document, {"text"}).kind == Node::Kind::text);
  CHECK(at(document, {"text"}).text == "1 m");
  CHECK(at(document, {"whole"}).number == 3.0);
  CHECK(at(document, {"whole"}).whole);
  CHECK(at(document, {"fraction"}).number == 3.0);
  CHECK_FALSE(at(document, {"fraction"}).whole);
  CHECK(at(document, {"yes"}).kind == Node::Kind::boolean);
  CHECK(at(document, {"yes"}).boolean);
  CHECK(at(document, {"day"}).kind == Node::Kind::other);
  CHECK(at(document, {"table"}).kind == Node::Kind::table);
  const Node& list = at(document, {"list"});
  REQUIRE(list.items.size() == 2);
  CHECK(list.items[0].number == 1.0);
  CHECK(list.items[1].text == "two");
  CHECK(document.root.find("absent") == nullptr);
}

TEST_CASE("keys and values know their line and column, counted from 1 in characters") {
  const CaseDocument document =
      parse("# é\n[beam]\n\"ä\" = \"ö\" # x\nb = { c = 1, d = [2, 30] }\n");
  const Node& beam = at(document, {"beam"});
  CHECK(beam.members[0].key_place.line == 3);
  CHECK(beam.members[0].key_place.column == 1);
  CHECK(beam.members[0].value.place.column == 7);
  const Node& d = at(document, {"beam", "b", "d"});
  CHECK(d.items[1].place.line == 4);
  CHECK(d.items[1].place.column == 22);
  CHECK(d.place.file == "case.toml");
}

TEST_CASE("members stand in the order of the file") {
  const CaseDocument document = parse("z = 1\nm = 2\na = 3\n");
  std::string order;
  for (const Node::Member& member : document.root.members) order += member.key;
  CHECK(order == "zma");
}

TEST_CASE("a problem at a place shows the line written there") {
  const CaseDocument document = parse(small);
  const Problem problem =
      document.problem_at(at(document, {"beam", "density"}).place, "wrong", "h");
  CHECK(problem.file == "case.toml");
  CHECK(problem.line == 2);
  CHECK(problem.column == 11);
  CHECK(problem.source_line == "density = \"7800 kg/m^3\"");
  CHECK(problem.hint == "h");
}

TEST_CASE("lines that end in CR LF are shown without it") {
  const CaseDocument document = parse("a = 1\r\nb = 2\r\n");
  CHECK(document.problem_at(at(document, {"b"}).place, "").source_line == "b = 2");
}

TEST_CASE("overrides replace and add values") {
  const CaseDocument document =
      parse(small, {"beam.density=7850 kg/m^3", "case.name=other", "case.cycles=1e6"});
  CHECK(at(document, {"beam", "density"}).text == "7850 kg/m^3");
  CHECK(at(document, {"case", "name"}).text == "other");
  CHECK(at(document, {"case", "cycles"}).number == 1e6);
}

TEST_CASE("overrides reach into arrays by number, and may be arrays and quoted texts") {
  const CaseDocument document = parse(small, {"beam.segments.1.length=\"3 m\"",
                                              "beam.points=[\"1 m\", \"2 m\"]", "beam.note=true"});
  const Node& segments = at(document, {"beam", "segments"});
  CHECK(segments.items[0].find("length")->text == "1.5 m");
  CHECK(segments.items[1].find("length")->text == "3 m");
  CHECK(at(document, {"beam", "points"}).items[1].text == "2 m");
  CHECK(at(document, {"beam", "note"}).boolean);
}

TEST_CASE("the item behind the last one of an array is added to it") {
  const CaseDocument document =
      parse(small, {"beam.segments.2={length = \"3 m\"}", "beam.segments.3={length = \"4 m\"}"});
  const Node& segments = at(document, {"beam", "segments"});
  REQUIRE(segments.items.size() == 4);
  CHECK(segments.items[1].find("length") != nullptr);
  CHECK(segments.items[2].find("length")->text == "3 m");
  CHECK(segments.items[3].find("length")->text == "4 m");
}

TEST_CASE("a number with a unit behind it is a text, what TOML knows is not") {
  const auto value_of = [](const std::string& value) {
    return at(parse(small, {"case.note=" + value}), {"case", "note"});
  };
  for (const char* text : {"16 mm", "-3.5e2 kN m", "+.5 t", "1 e5", "16 mm # wide", "1979-05-27 T",
                           "1979-05-27 07:32:00", "16  mm", "16mm", "e 5", " 16 mm", "- 5"}) {
    CAPTURE(text);
    CHECK(value_of(text).kind == Node::Kind::text);
    CHECK(value_of(text).text == text);
  }
  CHECK(value_of("16 # mm").number == 16.0);
  CHECK(value_of("16 ").number == 16.0);
}

TEST_CASE("the value of an override may hold an equals sign, and be empty") {
  const CaseDocument document = parse(small, {"case.title=a = b", "case.name="});
  CHECK(at(document, {"case", "title"}).text == "a = b");
  CHECK(at(document, {"case", "name"}).text.empty());
}

TEST_CASE("a part of a key with dots or an equals sign of its own stands in quotes") {
  const CaseDocument document =
      parse("[a.'b.c']\nd = 1\n[a.\"e = f\"]\nd = 1\n",
            {"a.\"b.c\".d=2", "a.'e = f'.d=3", " a . \"new one\" .d = 4", "a.6\" pipe.d=5"});
  CHECK(at(document, {"a", "b.c", "d"}).number == 2.0);
  CHECK(at(document, {"a", "e = f", "d"}).number == 3.0);
  CHECK(at(document, {"a", "new one", "d"}).number == 4.0);
  CHECK(at(document, {"a", "6\" pipe", "d"}).number == 5.0);
}

TEST_CASE("a problem with an overridden value points into the override") {
  const CaseDocument document = parse(small, {"beam.density=heavy"});
  const Problem problem = document.problem_at(at(document, {"beam", "density"}).place, "wrong");
  CHECK(problem.source_line == "--set beam.density=heavy");
  CHECK(problem.source_line.substr(static_cast<std::size_t>(problem.column) - 1) == "heavy");
}

TEST_CASE("overrides that set nothing are refused") {
  CHECK(problem_of(small, {"beam.density"}).message.find("KEY=VALUE") != std::string::npos);
  CHECK(problem_of(small, {"=5"}).message.find("KEY=VALUE") != std::string::npos);
  CHECK(problem_of(small, {""}).message.find("KEY=VALUE") != std::string::npos);
  CHECK(problem_of(small, {"beam.=5"}).message.find("KEY=VALUE") != std::string::npos);
  CHECK(problem_of(small, {"beam..density=5"}).message.find("KEY=VALUE") != std::string::npos);
  // Below a text, an item that is not there, an item that is no number.
  CHECK(problem_of(small, {"beam.density.x=5"}).message.find("density") != std::string::npos);
  CHECK(problem_of(small, {"beam.segments.2.length=5"}).message.find("\"2\"") != std::string::npos);
  CHECK(problem_of(small, {"beam.segments.7=5"}).message.find("7") != std::string::npos);
  CHECK(problem_of(small, {"beam.segments.first.length=5"}).message.find("first") !=
        std::string::npos);
}

TEST_CASE("text that is not UTF-8 is refused at its place") {
  // A Latin-1 byte, a cut sequence, overlong slashes, a surrogate, one beyond Unicode.
  for (const char* bytes : {"\xE9", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xF0\x80\x80\xAF",
                            "\xED\xA0\x80", "\xF4\x90\x80\x80", "\x80"}) {
    const Problem problem = problem_of("a = 1\nb = \"é" + std::string(bytes) + "\"\n");
    CHECK(problem.message.find("UTF-8") != std::string::npos);
    CHECK(problem.line == 2);
    CHECK(problem.column == 7);
  }
}

TEST_CASE("an override that is not UTF-8 is refused") {
  CHECK(problem_of(small, {"case.title=\xFF"}).message.find("UTF-8") != std::string::npos);
}

TEST_CASE("a key of 100 000 dots is refused, not followed") {
  std::string key = "a";
  for (int i = 0; i < 100000; ++i) key += ".a";
  CHECK(problem_of("b = 1\n" + key + " = 1\n").line == 2);
  CHECK(problem_of("[" + key + "]\n").line == 1);
  CHECK(problem_of("x = { " + key + " = 1 }\n").line == 1);
  CHECK_THROWS_AS(parse(small, {key + "=1"}), InputError);
}

TEST_CASE("dots in texts, comments and numbers are no key parts") {
  const std::string dots(1000, '.');
  const CaseDocument document =
      parse("a = \"" + dots + "\" # " + dots + "\nb = '''\n" + dots + "'''\nc = [1.0, 2.0, 3.0]\n");
  CHECK(at(document, {"a"}).text == dots);
  CHECK(at(document, {"b"}).text == dots);
}

TEST_CASE("arrays nested without end are refused") {
  CHECK_THROWS_AS(parse("a = " + std::string(100000, '[')), InputError);
}

TEST_CASE("a TOML error has its line and column") {
  const Problem problem = problem_of("a = 1\nb = = 2\n");
  CHECK(problem.line == 2);
  CHECK(problem.column >= 4);
  CHECK(problem.source_line == "b = = 2");
  CHECK(problem.message.find("TOML") != std::string::npos);
}

TEST_CASE("a missing file and a folder are refused without a line") {
  for (const char* path : {"/no/such/case.toml", "/"}) {
    try {
      read_document(path, {});
      FAIL("read " << path);
    } catch (const InputError& error) {
      CHECK(error.problems().front().line == 0);
      CHECK(error.problems().front().file == path);
    }
  }
}

TEST_CASE("sha256 of the input: FIPS 180-4 and values of sha256sum (GNU coreutils)") {
  // The empty message, FIPS 180-4 (NIST example values).
  CHECK(parse("").sha256 == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  // printf 'a = 1\n' | sha256sum
  CHECK(parse("a = 1\n").sha256 ==
        "cb78bd8a17f7b751fe0d4663366dcbc257204033ef7ddd64b1f2969573b5b2e2");
  // printf '[case]\nname = "größe"\n' | sha256sum
  CHECK(parse("[case]\nname = \"größe\"\n").sha256 ==
        "aa137f3d1e873651e8017ce9285ac8cacc2a18e5a155256198a4d39fdc73e4d2");
  // An override counts as a line behind it: printf 'a = 1\n\n--set a=2' | sha256sum
  CHECK(parse("a = 1\n", {"a=2"}).sha256 ==
        "44df1c57173aae3ad1b8ef76772f9dc0326cf9e8162951c83bb7d8ecf5408ec0");
}

TEST_CASE("files that a case names count as lines of hashes behind its own") {
  CaseDocument document = parse("a = 1\n");
  CHECK(document.sha256_of_input() == document.sha256);
  document.add_file("one.csv", "folder/one.csv", "1, 2\n");
  document.add_file("two.csv", "folder/two.csv", "");
  // printf 'a = 1\n' > a; printf '1, 2\n' > b; touch c; sha256sum a b c | cut -c1-64 | sha256sum
  CHECK(document.sha256_of_input() ==
        "dd4c94500b7f4b04c4f318d9e8288b1597ad4802136426f104b905ac8811a446");
  CHECK(document.problem_at({"folder/one.csv", 1, 1}, "wrong").source_line == "1, 2");
}

}  // namespace case_document_test
