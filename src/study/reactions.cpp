#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult reactions(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
