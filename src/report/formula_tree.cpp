#include "boxbeam/report/formula_tree.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace boxbeam::report {
namespace {

using Kind = FormulaNode::Kind;

/// Units that numbers of a sheet have. A newton is written in kilonewtons, for N is a cut force.
constexpr std::array<std::string_view, 10> units{"kN", "MPa", "GPa", "mm",  "m",
                                                 "s",  "kg",  "Hz",  "deg", "rad"};
constexpr std::array<std::string_view, 10> functions{"sqrt", "exp", "ln",  "log", "min",
                                                     "max",  "abs", "sin", "cos", "tan"};
/// Deeper nesting is no formula that anybody reads.
constexpr int deepest = 40;
constexpr std::size_t longest = 4000;

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_angle_function(std::string_view name) {
  return name == "sin" || name == "cos" || name == "tan";
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

FormulaNode node(Kind kind, std::vector<FormulaNode> parts, std::string text = "") {
  return {kind, std::move(text), "", std::move(parts)};
}

/// Recursive descent; what cannot be read leaves `failed_` behind.
class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  std::optional<FormulaNode> parse() {
    if (text_.size() > longest) return std::nullopt;
    FormulaNode whole = relation();
    skip_spaces();
    if (failed_ || at_ != text_.size()) return std::nullopt;
    return whole;
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }

  void skip_spaces() {
    while (peek() == ' ') ++at_;
  }

  bool take(char c) {
    skip_spaces();
    if (peek() != c) return false;
    ++at_;
    return true;
  }

  FormulaNode fail() {
    failed_ = true;
    at_ = text_.size();
    return {};
  }

  /// Guards against nesting that would use up the stack.
  struct Depth {
    explicit Depth(int& depth) : count(depth) { ++count; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;
    ~Depth() { --count; }
    int& count;
  };

  FormulaNode relation() {
    const Depth depth(depth_);
    if (depth_ > deepest) return fail();
    FormulaNode left = sum();
    for (;;) {
      skip_spaces();
      std::string sign;
      if (peek() == '<' || peek() == '>' || peek() == '=') sign += text_[at_++];
      if (sign.empty() || failed_) return left;
      if (sign != "=" && peek() == '=') sign += text_[at_++];
      FormulaNode right = sum();
      left = node(Kind::relation, {std::move(left), std::move(right)}, sign);
    }
  }

  FormulaNode sum() {
    std::vector<FormulaNode> terms;
    const auto add = [&](bool minus) {
      FormulaNode of = term();
      if (minus) {
        FormulaNode negative = node(Kind::negative, {});
        negative.parts.push_back(std::move(of));
        of = std::move(negative);
      }
      terms.push_back(std::move(of));
    };
    add(take('-'));
    while (!failed_) {
      if (take('+'))
        add(false);
      else if (take('-'))
        add(true);
      else
        break;
    }
    if (failed_) return {};
    if (terms.size() == 1) return std::move(terms.front());
    return node(Kind::sum, std::move(terms));
  }

  /// The word that begins here, without taking it.
  std::string_view word() const {
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    return std::string_view(text_).substr(at_, end - at_);
  }

  bool word_ends_after(std::size_t length) const {
    const char c = peek(length);
    return c != '_' && !is_letter(c) && !is_digit(c);
  }

  /// Whether an "x" between spaces follows that multiplies.
  bool at_times() const {
    return peek() == 'x' && at_ > 0 && text_[at_ - 1] == ' ' && peek(1) == ' ';
  }

  FormulaNode term() {
    const Depth depth(depth_);
    if (depth_ > deepest) return fail();
    skip_spaces();
    const std::string_view first = word();
    if ((first == "sum" || first == "int") && word_ends_after(first.size())) {
      std::string name(first);
      at_ += name.size();
      std::vector<FormulaNode> operand;
      operand.push_back(term());
      return node(Kind::large, std::move(operand), std::move(name));
    }
    FormulaNode left = product(false);
    while (!failed_) {
      skip_spaces();
      if (at_times()) {
        ++at_;
        left = node(Kind::times, {std::move(left), product(false)});
      } else if (take('/')) {
        left = node(Kind::fraction, {std::move(left), product(true)});
        skip_spaces();
        if (!failed_ && begins_factor()) {
          // What follows the denominator multiplies the fraction.
          FormulaNode more = product(false);
          std::vector<FormulaNode> factors;
          factors.push_back(std::move(left));
          if (more.kind == Kind::product) {
            for (FormulaNode& part : more.parts) factors.push_back(std::move(part));
          } else {
            factors.push_back(std::move(more));
          }
          left = node(Kind::product, std::move(factors));
        }
      } else {
        return left;
      }
    }
    return left;
  }

  bool begins_factor() const {
    if (at_times()) return false;
    const char c = peek();
    return is_letter(c) || is_digit(c) || c == '(' || c == '[';
  }

  bool at_group() const { return peek() == '(' || peek() == '['; }

  FormulaNode product(bool denominator) {
    skip_spaces();
    if (!begins_factor()) return fail();
    const bool only_group = denominator && at_group();
    std::vector<FormulaNode> factors;
    factors.push_back(factor());
    for (;;) {
      skip_spaces();
      if (failed_ || only_group || !begins_factor() || (denominator && at_group())) break;
      factors.push_back(factor());
    }
    if (failed_) return {};
    if (factors.size() == 1) return std::move(factors.front());
    return node(Kind::product, std::move(factors));
  }

  FormulaNode factor() {
    FormulaNode base = atom();
    if (failed_ || peek() != '^') return base;
    ++at_;
    FormulaNode exponent = exponent_of();
    return node(Kind::power, {std::move(base), std::move(exponent)});
  }

  FormulaNode exponent_of() {
    if (peek() == '-') {
      ++at_;
      std::vector<FormulaNode> part;
      part.push_back(atom(false));
      return node(Kind::negative, std::move(part));
    }
    if (!begins_factor()) return fail();
    return atom(false);
  }

  FormulaNode atom(bool with_unit = true) {
    if (at_group()) return group();
    if (is_digit(peek())) return number(with_unit);
    if (!is_letter(peek())) return fail();
    return name();
  }

  FormulaNode group() {
    const char close = text_[at_++] == '(' ? ')' : ']';
    std::vector<FormulaNode> inside;
    inside.push_back(relation());
    if (!take(close)) return fail();
    return node(Kind::group, std::move(inside));
  }

  FormulaNode number(bool with_unit) {
    FormulaNode of;
    of.kind = Kind::number;
    const auto digits = [&] {
      while (is_digit(peek())) of.text += text_[at_++];
    };
    digits();
    if (peek() == '.' && is_digit(peek(1))) {
      of.text += text_[at_++];
      digits();
    }
    const bool sign = peek(1) == '-' || peek(1) == '+';
    if (peek() == 'e' && is_digit(peek(sign ? 2 : 1))) {
      of.text += text_[at_++];
      if (sign) of.text += text_[at_++];
      digits();
    }
    if (with_unit) of.index = unit();
    return of;
  }

  /// "kN m", "mm^-2", "%", or nothing.
  std::string unit() {
    std::string of;
    for (;;) {
      const std::size_t before = at_;
      skip_spaces();
      if (peek() == '%') {
        ++at_;
        return of.empty() ? "%" : of;
      }
      const std::string_view next = word();
      const bool called = peek(next.size()) == '(';
      if (!is_one_of(units, next) || !word_ends_after(next.size()) || called) {
        at_ = before;
        return of;
      }
      if (!of.empty()) of += ' ';
      of += next;
      at_ += next.size();
      if (peek() != '^') continue;
      const std::size_t length = peek(1) == '-' ? 2 : 1;
      if (!is_digit(peek(length))) continue;
      of += text_.substr(at_, length + 1);
      at_ += length + 1;
    }
  }

  FormulaNode name() {
    const std::string base(word());
    if (is_one_of(functions, base) && word_ends_after(base.size())) return call(base);
    if (base == "d" && peek(1) == '/' && peek(2) == 'd' && is_letter(peek(3))) return derivative();
    at_ += base.size();
    FormulaNode of;
    of.kind = Kind::name;
    of.text = base;
    if (peek() != '_') return of;
    ++at_;
    std::string index = index_word();
    if (index.empty()) return fail();
    // "d_sigma" is a range, with an index of its own.
    if (base == "d" && (index == "sigma" || index == "tau")) {
      of.text = "d_" + index;
      index.clear();
      if (peek() == '_') {
        ++at_;
        index = index_word();
        if (index.empty()) return fail();
      }
    }
    of.index = index;
    return of;
  }

  std::string index_word() {
    std::string index;
    while (is_letter(peek()) || is_digit(peek()) ||
           (peek() == ',' && !index.empty() && (is_letter(peek(1)) || is_digit(peek(1))))) {
      index += text_[at_++];
    }
    return index;
  }

  FormulaNode call(const std::string& name) {
    const Depth depth(depth_);
    if (depth_ > deepest) return fail();
    at_ += name.size();
    std::vector<FormulaNode> arguments;
    if (peek() == '(') {
      ++at_;
      do arguments.push_back(relation());
      while (!failed_ && take(','));
      if (!take(')')) return fail();
      return node(Kind::call, std::move(arguments), name);
    }
    // "cos 2theta": a number and a name.
    skip_spaces();
    if (!is_angle_function(name) || !begins_factor() || at_group()) return fail();
    std::vector<FormulaNode> factors;
    if (is_digit(peek())) factors.push_back(number(true));
    if (is_letter(peek())) factors.push_back(this->name());
    if (factors.size() == 1)
      arguments.push_back(std::move(factors.front()));
    else
      arguments.push_back(node(Kind::product, std::move(factors)));
    return node(Kind::call, std::move(arguments), name);
  }

  FormulaNode derivative() {
    at_ += 2;
    std::string by(word());
    at_ += by.size();
    if (peek() != '(') return fail();
    std::vector<FormulaNode> part;
    part.push_back(group());
    return node(Kind::derivative, std::move(part), by);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool failed_ = false;
};

}  // namespace

bool is_tall(const FormulaNode& node) {
  if (node.kind == Kind::fraction || node.kind == Kind::large || node.kind == Kind::derivative)
    return true;
  return std::any_of(node.parts.begin(), node.parts.end(), is_tall);
}

std::optional<FormulaNode> parse_formula(const std::string& text) { return Parser(text).parse(); }

}  // namespace boxbeam::report
