#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// Reading a page that is both HTML and XML, for tests: strict, so that what a browser would repair
/// is found.
namespace test {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;  ///< of itself and all inside, as a reader sees it
};

struct Markup {
  std::vector<Element> elements;  ///< in the order of their start tags
  std::string fault;              ///< why it is not well-formed; "" where it is
};

/// Well-formed: every tag is closed in its place, attributes are quoted and unique, nothing but the
/// five predefined entities and decimal characters is referred to. Source: XML 1.0, 2.1.
Markup read_markup(std::string_view page);

std::vector<Element> elements_named(const Markup& markup, std::string_view name);

}  // namespace test
