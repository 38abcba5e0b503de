#include "boxbeam/report/marked_text.hpp"

namespace boxbeam::report {

const char* to_text(Mark mark) {
  switch (mark) {
    case Mark::passes: return "passes";
    case Mark::fails: return "FAILS";
    case Mark::not_applicable: return "not applicable";
    case Mark::none: break;
  }
  return "";
}

MarkedText& MarkedText::operator+=(const MarkedText& more) {
  for (const Word& word : more.words)
    words.push_back({text.size() + word.begin, text.size() + word.end, word.mark});
  text += more.text;
  return *this;
}

}  // namespace boxbeam::report
