#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace boxbeam::report {

/// How a row, a step or a verdict is to be marked.
enum class Mark { none, passes, fails, not_applicable };

/// "passes", "FAILS", "not applicable".
const char* to_text(Mark mark);

/// A text with the words in it that say a result, for a terminal that shows them in colour. Colour
/// adds nothing: the words say it as well.
struct MarkedText {
  struct Word {
    std::size_t begin, end;
    Mark mark;
  };

  MarkedText() = default;
  MarkedText(std::string of, Mark mark = Mark::none) : text(std::move(of)) {
    if (mark != Mark::none) words.push_back({0, text.size(), mark});
  }
  MarkedText(const char* of) : text(of) {}

  MarkedText& operator+=(const MarkedText& more);

  std::string text;
  std::vector<Word> words;  ///< in order
};

}  // namespace boxbeam::report
