#include "support/markup.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace test {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view page) : page_(page) {}

  Markup read() {
    while (at_ < page_.size() && markup_.fault.empty()) {
      if (page_[at_] != '<') {
        characters(page_.substr(at_, page_.find('<', at_) - at_));
      } else if (skip_to("<!DOCTYPE", ">")) {
        continue;
      } else if (starts("<![CDATA[")) {
        const std::size_t end = page_.find("]]>", at_);
        if (end == std::string_view::npos) return failed("CDATA without end");
        add(std::string(page_.substr(at_ + 9, end - at_ - 9)));
        at_ = end + 3;
      } else if (starts("</")) {
        close();
      } else {
        open();
      }
    }
    if (markup_.fault.empty() && !open_.empty()) return failed("an element is not closed");
    return markup_;
  }

 private:
  bool starts(std::string_view with) const { return page_.substr(at_).starts_with(with); }

  bool skip_to(std::string_view from, std::string_view to) {
    if (!starts(from)) return false;
    at_ = page_.find(to, at_) + to.size();
    return true;
  }

  Markup failed(const std::string& why) {
    markup_.fault = why + " near: " + std::string(page_.substr(at_, 60));
    return markup_;
  }

  void add(const std::string& text) {
    for (const std::size_t i : open_) markup_.elements[i].text += text;
  }

  void characters(std::string_view raw) {
    add(resolved(raw));
    at_ += raw.size();
  }

  /// Text with its entities resolved.
  std::string resolved(std::string_view raw) {
    static const std::map<std::string, std::string> known{
        {"amp", "&"}, {"lt", "<"}, {"gt", ">"}, {"quot", "\""}};
    std::string text;
    for (std::size_t i = 0; i < raw.size(); ++i) {
      const char c = raw[i];
      if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
        failed("control character");
      if (c != '&') {
        text += c;
        continue;
      }
      const std::size_t end = raw.find(';', i);
      const std::string name(raw.substr(i + 1, end == std::string_view::npos ? 0 : end - i - 1));
      if (known.count(name) == 1) {
        text += known.at(name);
      } else if (name.size() > 1 && name[0] == '#') {
        text += static_cast<char>(std::atoi(name.c_str() + 1));
      } else {
        failed("unknown entity &" + name + ";");
        return text;
      }
      i = end;
    }
    return text;
  }

  std::string name() {
    const std::size_t begin = at_;
    while (at_ < page_.size() && (std::isalnum(static_cast<unsigned char>(page_[at_])) != 0 ||
                                  page_[at_] == '-' || page_[at_] == ':')) {
      ++at_;
    }
    return std::string(page_.substr(begin, at_ - begin));
  }

  void spaces() {
    while (at_ < page_.size() && (page_[at_] == ' ' || page_[at_] == '\n')) ++at_;
  }

  void open() {
    ++at_;
    Element element;
    element.name = name();
    if (element.name.empty()) {
      failed("< that begins no tag");
      return;
    }
    for (spaces(); at_ < page_.size() && page_[at_] != '>' && page_[at_] != '/'; spaces()) {
      const std::string key = name();
      if (key.empty() || !starts("=\"")) {
        failed("attribute without name or quoted value");
        return;
      }
      at_ += 2;
      const std::size_t end = page_.find('"', at_);
      const std::string_view raw = page_.substr(at_, end - at_);
      if (raw.find('<') != std::string_view::npos) failed("< in an attribute");
      if (!element.attributes.emplace(key, resolved(raw)).second) failed("attribute given twice");
      at_ = end + 1;
    }
    markup_.elements.push_back(std::move(element));
    if (starts("/>")) {
      at_ += 2;
      return;
    }
    ++at_;
    open_.push_back(markup_.elements.size() - 1);
  }

  void close() {
    at_ += 2;
    const std::string of = name();
    if (open_.empty() || markup_.elements[open_.back()].name != of) {
      failed("</" + of + "> closes nothing");
      return;
    }
    open_.pop_back();
    ++at_;
  }

  std::string_view page_;
  std::size_t at_ = 0;
  std::vector<std::size_t> open_;
  Markup markup_;
};

}  // namespace

Markup read_markup(std::string_view page) { return Reader(page).read(); }

std::vector<Element> elements_named(const Markup& markup, std::string_view name) {
  std::vector<Element> found;
  std::copy_if(markup.elements.begin(), markup.elements.end(), std::back_inserter(found),
               [&](const Element& element) { return element.name == name; });
  return found;
}

}  // namespace test
