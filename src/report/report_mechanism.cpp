#include <iterator>

#include "front_end_text.hpp"

namespace boxbeam::report {

Chapter mechanism_chapter(const Source& source) {
  const std::unique_ptr<const FrontEndText> text = front_end_text_of(source.project);
  Chapter chapter{text->heading(), {}};
  if (source.level == ReportLevel::summary) return chapter;
  add_pictures(source, FigurePlace::mechanism, chapter.blocks);
  std::vector<Block> blocks = text->blocks(source.verification);
  chapter.blocks.insert(chapter.blocks.end(), std::make_move_iterator(blocks.begin()),
                        std::make_move_iterator(blocks.end()));
  return chapter;
}

}  // namespace boxbeam::report
