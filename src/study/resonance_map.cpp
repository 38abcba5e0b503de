#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

Map resonance_map(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
