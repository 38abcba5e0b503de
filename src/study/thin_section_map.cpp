#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

Map thin_section_map(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
