// A tree written as TOML reads back as itself: every shipped case, and what TOML makes hard.

#include "boxbeam/project/toml_text.hpp"

#include <algorithm>
#include <filesystem>

#include "catch.hpp"
#include "support/program.hpp"

namespace toml_text_test {

using namespace boxbeam;

namespace {

/// Alike but for the order in which a table's members stand.
bool same(const Node& a, const Node& b) {
  if (a.kind != b.kind || a.members.size() != b.members.size() || a.items.size() != b.items.size())
    return false;
  if (a.text != b.text || a.boolean != b.boolean || a.whole != b.whole) return false;
  if (a.kind == Node::Kind::number && a.number != b.number) return false;
  for (std::size_t i = 0; i < a.items.size(); ++i)
    if (!same(a.items[i], b.items[i])) return false;
  return std::all_of(a.members.begin(), a.members.end(), [&](const Node::Member& member) {
    const Node* const other = b.find(member.key);
    return other != nullptr && same(member.value, *other);
  });
}

bool comes_back(const std::string& text) {
  const Node root = parse_document("case.toml", text, {}).root;
  return same(root, parse_document("written.toml", toml_text(root), {}).root);
}

}  // namespace

TEST_CASE("toml_text: every shipped case reads back as it is") {
  std::size_t cases = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::project_file("sections"))) {
    if (entry.path().extension() != ".toml") continue;
    INFO(entry.path().string());
    CHECK(comes_back(test::read_file(entry.path())));
    ++cases;
  }
  CHECK(cases >= 20);
}

TEST_CASE("toml_text: texts, keys and numbers that need care") {
  CHECK(comes_back("text = \"a \\\"quote\\\", a \\\\ and a\\nline\\u0001\"\n"));
  CHECK(comes_back("\"a.b c\" = 1\n[\"x.y\".\"\"]\nz = [[1, 2.5], [\"m\"], [{ a = 1.0 }, 3]]\n"));
  CHECK(comes_back("a = 0.1\nb = 1e300\nc = -7\nd = 3.0\ne = true\nf = []\n[g]\n[h.i]\n"));
  CHECK(comes_back("[[a]]\nb = 1\n[[a.c]]\nd = 2\n[a.e]\nf = 3\n[[a]]\n"));
}

}  // namespace toml_text_test
