#include "robot_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <charconv>
#include <cmath>
#include <set>
#include <sstream>
#include <string_view>

#include "text_file.hpp"

namespace boxbeam::robots {
namespace {

using XmlTree = boost::property_tree::ptree;

/// Behind the tag that begins at a place, or npos; ">" may stand in quotes.
std::size_t end_of_tag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (std::size_t i = at + 1; i < text.size(); ++i) {
    const char c = text[i];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return i + 1;
    }
  }
  return std::string_view::npos;
}

/// The numbers of a text that holds nothing else; all finite.
std::optional<std::vector<double>> numbers_in_text(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const char* const begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
    const char* const end = word.data() + word.size();
    double number = 0.0;
    const auto [behind, error] = std::from_chars(begin, end, number);
    if (error != std::errc() || behind != end || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

/// An element of a parsed document; `next`: its place among all.
XmlElement element_of(const std::string& tag, const XmlTree& tree,
                      const std::vector<std::size_t>& places, std::size_t& next) {
  XmlElement element{tag, {}, {}, next < places.size() ? places[next] : 0};
  ++next;
  for (const auto& [name, inside] : tree) {
    if (name != "<xmlattr>") {
      element.children.push_back(element_of(name, inside, places, next));
      continue;
    }
    for (const auto& [attribute, value] : inside)
      element.attributes.emplace(attribute, value.data());
  }
  return element;
}

}  // namespace

const std::string* XmlElement::attribute(const std::string& name) const {
  const auto found = attributes.find(name);
  return found == attributes.end() ? nullptr : &found->second;
}

std::size_t XmlElement::count(const std::string& of_tag) const {
  return static_cast<std::size_t>(
      std::count_if(children.begin(), children.end(),
                    [&](const XmlElement& child) { return child.tag == of_tag; }));
}

RobotFile::RobotFile(std::string file, const std::string& text, std::string format,
                     std::string example)
    : file_(std::move(file)),
      text_(text),
      format_(std::move(format)),
      example_(std::move(example)) {}

void RobotFile::problem(std::size_t at, std::string message, std::string hint) {
  const LineColumn place = position_of(text_, at);
  const std::size_t begin = at == 0 ? 0 : text_.rfind('\n', at - 1) + 1;
  std::string line = text_.substr(begin, text_.find('\n', begin) - begin);
  if (line.ends_with('\r')) line.pop_back();
  problems_.push_back(
      {file_, place.line, place.column, std::move(line), std::move(message), std::move(hint)});
}

void RobotFile::problem(const RobotElement& of, const std::string& message, std::string hint) {
  problem(of.element->at, of.what + ": " + message, std::move(hint));
}

void RobotFile::problem_of_file(std::string message, std::string hint) {
  problems_.push_back({file_, 0, 0, {}, std::move(message), std::move(hint)});
}

void RobotFile::raise() const {
  if (!problems_.empty()) throw InputError(problems_);
}

/// Where elements begin, in their order. Boost.PropertyTree keeps no places, compares no names of
/// closing tags and calls itself as deep as elements lie in each
/// other: this looks at all three.
std::vector<std::size_t> RobotFile::places_of_elements() {
  constexpr std::size_t deepest = 1000;
  constexpr std::size_t none = std::string_view::npos;
  const std::string_view text = text_;
  std::vector<std::string_view> open;
  std::vector<std::size_t> places;
  const auto behind = [&](std::size_t from, std::string_view end) {
    const std::size_t found = text.find(end, from);
    return found == none ? none : found + end.size();
  };
  std::size_t end = 0;
  for (std::size_t at = text.find('<'); at != none; at = text.find('<', end)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      end = behind(at + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      end = behind(at, "]]>");
    } else if (rest.starts_with("<?")) {
      end = behind(at, "?>");
    } else if (rest.starts_with("<!")) {
      end = behind(at, ">");
    } else {
      end = end_of_tag(text, at);
      const std::string_view tag = text.substr(at, end == none ? none : end - at);
      const std::size_t first = tag.starts_with("</") ? 2 : 1;
      const std::string_view name =
          tag.substr(first, tag.find_first_of(" \t\r\n/>", first) - first);
      if (first == 2) {
        if (open.empty() || open.back() != name) {
          problem(at, fmt::format("</{}> closes nothing that is open", name),
                  open.empty() ? "" : fmt::format("<{}> is open", open.back()));
          return places;
        }
        open.pop_back();
        continue;
      }
      if (name.starts_with("xacro:") || tag.find("${") != none) {
        problem(at, "this is a xacro file, from which a URDF file is made first",
                "write: xacro ROBOT.xacro > ROBOT.urdf");
        return places;
      }
      places.push_back(at);
      if (!tag.ends_with("/>")) open.push_back(name);
      if (open.size() > deepest) {
        problem(at, "elements lie too deep in each other", "");
        return places;
      }
    }
    if (end == none) {
      problem(at, "this is no XML: what begins here has no end", "");
      return places;
    }
  }
  return places;
}

XmlElement RobotFile::outermost(const std::string& tag) {
  namespace xml = boost::property_tree::xml_parser;
  const std::string is = fmt::format("{} file is {}", format_, example_);
  if (const std::size_t at = std::min(find_not_utf8(text_), text_.find('\0'));
      at != std::string::npos)
    problem(at, "this is no text in UTF-8",
            fmt::format("{} file is XML; convert it to UTF-8", format_));
  raise();
  const std::vector<std::size_t> places = places_of_elements();
  raise();
  XmlTree document;
  std::istringstream stream(text_);
  try {
    xml::read_xml(stream, document, xml::no_comments);
  } catch (const xml::xml_parser_error& error) {
    std::size_t at = 0;
    for (unsigned long line = 1; line < error.line(); ++line) at = text_.find('\n', at) + 1;
    problem(at, fmt::format("this is no XML: {}", error.message()), is);
  }
  raise();
  if (document.size() != 1 || document.front().first != tag)
    problem_of_file(fmt::format("there is no <{}>", tag), is);
  raise();
  std::size_t next = 0;
  return element_of(tag, document.front().second, places, next);
}

const XmlElement* RobotFile::element_in(const RobotElement& of, const XmlElement& in,
                                        const char* tag) {
  const XmlElement* found = nullptr;
  for (const XmlElement& child : in.children) {
    if (child.tag != tag) continue;
    if (found != nullptr) {
      problem(of, fmt::format("<{}> stands there twice", tag), "leave one of them");
      break;
    }
    found = &child;
  }
  return found;
}

std::optional<std::vector<double>> RobotFile::numbers(const RobotElement& of,
                                                      const std::string& tag,
                                                      const std::string& name,
                                                      const std::string& text, std::size_t least,
                                                      std::size_t most) {
  std::optional<std::vector<double>> found = numbers_in_text(text);
  if (found && found->size() >= least && found->size() <= most) return found;
  problem(of,
          fmt::format("{} = \"{}\" of <{}> wants {}", name, text, tag,
                      most == 1       ? "a number"
                      : least == most ? fmt::format("{} numbers", most)
                                      : fmt::format("{} to {} numbers", least, most)),
          most == 1   ? "write for example \"0.5\""
          : most == 3 ? "write for example \"0 0 0.5\""
                      : "numbers stand with blanks between them");
  return {};
}

void RobotFile::check_names(const Robot& robot, const std::vector<RobotElement>& links,
                            const std::vector<RobotElement>& joints) {
  std::set<std::string> link_names, joint_names;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (!link_names.insert(robot.links[i].name).second)
      problem(links[i], "another link has this name", "each link has a name of its own");
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const std::vector<Coordinate> coordinates = coordinates_of(robot.joints[i]);
    std::vector<std::string> names{robot.joints[i].name};
    if (coordinates.size() > 1)
      for (const Coordinate& of : coordinates) names.push_back(of.name);
    for (const std::string& name : names) {
      if (joint_names.insert(name).second) continue;
      problem(joints[i], fmt::format("another joint is called \"{}\"", name),
              "each joint has a name of its own; the movements of a joint \"a\" with several are "
              "\"a.1\", \"a.2\" ...");
    }
  }
}

void RobotFile::check_mimics(const Robot& robot, const std::vector<RobotElement>& elements) {
  const std::vector<Joint>& joints = robot.joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    std::size_t at = i;
    for (std::size_t steps = 0; joints[at].mimic; at = joints[at].mimic->joint) {
      if (++steps <= joints.size()) continue;
      problem(elements[i], "it mimics itself by way of others", "let one of them mimic none");
      return;
    }
  }
}

bool is_plain(const std::string& name) {
  return std::none_of(name.begin(), name.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

}  // namespace boxbeam::robots
