#include "boxbeam/study/topics.hpp"

namespace boxbeam::study {

TopicResult sections(const Scenes&, const Effort&) { return {}; }

}  // namespace boxbeam::study
