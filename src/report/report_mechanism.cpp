#include <fmt/format.h>

#include <iterator>

#include "blocks.hpp"
#include "report_parts.hpp"

namespace boxbeam::report {

Chapter mechanism_chapter(const Source& source) {
  const Project& project = source.project;
  const Verification& verification = source.verification;
  Chapter chapter{"Mechanism", {}};
  if (source.level == ReportLevel::summary) return chapter;
  add_pictures(source, {"mechanism"}, chapter.blocks);
  std::vector<Block> blocks = in_space(project) ? spatial_blocks(spatial_of(project))
                              : verification.elastic
                                  ? flexible_blocks(flexible_of(project), verification.model.chosen)
                                  : planar_blocks(project, *verification.motions.front().closure);
  chapter.blocks.insert(chapter.blocks.end(), std::make_move_iterator(blocks.begin()),
                        std::make_move_iterator(blocks.end()));
  return chapter;
}

}  // namespace boxbeam::report
