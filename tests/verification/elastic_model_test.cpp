#include "boxbeam/verification/elastic_model.hpp"

#include "boxbeam/project/project.hpp"
#include "catch.hpp"
#include "support/program.hpp"

namespace boxbeam {

TEST_CASE("A model takes the links of a mechanism as it says", "[flexible][elastic_model]") {
  const Project project = read_project(test::project_file("sections/drill-truck/truck.toml"));
  const flexible::Mechanism& given = flexible_of(project);

  const flexible::Mechanism rigid = modelled(given, {ModelLevel::rigid, 0, 0, {}, false});
  for (std::size_t k = 0; k < given.links.size(); ++k) {
    CHECK(rigid.links[k].kind == flexible::LinkKind::rigid);
    const flexible::RigidMass before = flexible::rigid_mass_of(given.links[k]);
    const flexible::RigidMass after = flexible::rigid_mass_of(rigid.links[k]);
    CHECK(after.mass == before.mass);
    CHECK(after.inertia == before.inertia);
    CHECK(after.centre == before.centre);
    // How the mass lies stays known.
    CHECK(rigid.links[k].stretches.size() == given.links[k].stretches.size());
  }
  CHECK(rigid.joints.size() == given.joints.size());

  const flexible::Mechanism finer =
      modelled(given, {ModelLevel::flexible, 0, 9, flexible::Element::classical, true});
  CHECK(finer.element == flexible::Element::classical);
  for (std::size_t k = 0; k < given.links.size(); ++k) {
    const flexible::Link& link = given.links[k];
    if (link.kind == flexible::LinkKind::rigid) continue;
    CHECK(finer.links[k].parts == 9);
    const bool bends = link.kind == flexible::LinkKind::bending;
    CHECK(finer.links[k].kind == (bends ? flexible::LinkKind::full : link.kind));
  }
}

}  // namespace boxbeam
