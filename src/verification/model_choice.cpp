#include "boxbeam/verification/model_choice.hpp"

namespace boxbeam {

const char* to_text(ModelLevel level) {
  switch (level) {
    case ModelLevel::rigid: return "rigid";
    case ModelLevel::quasi_static: return "quasi-static";
    case ModelLevel::modal: return "modal";
    case ModelLevel::flexible: return "flexible";
  }
  return "";
}

}  // namespace boxbeam
