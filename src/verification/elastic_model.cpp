#include "boxbeam/verification/elastic_model.hpp"

namespace boxbeam {

flexible::Mechanism modelled(flexible::Mechanism mechanism, const ElasticModel& model) {
  using flexible::LinkKind;
  if (model.element) mechanism.element = *model.element;
  for (flexible::Link& link : mechanism.links) {
    if (link.kind == LinkKind::rigid) continue;
    if (model.level == ModelLevel::rigid) {
      link.rigid = flexible::rigid_mass_of(link);
      link.kind = LinkKind::rigid;
      continue;
    }
    if (model.parts > 0) link.parts = model.parts;
    if (model.axial && link.kind == LinkKind::bending) link.kind = LinkKind::full;
  }
  return mechanism;
}

}  // namespace boxbeam
