#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

Map toggle_map(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
