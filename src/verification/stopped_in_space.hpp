#pragma once

#include <map>
#include <memory>
#include <optional>

#include "boxbeam/beam/cut_force_diagram.hpp"
#include "boxbeam/beam/flexibility_profile.hpp"
#include "boxbeam/mechanism/spatial/chain.hpp"
#include "boxbeam/project/project.hpp"

namespace boxbeam {

/// Of a mechanism's beams in space, which are the same however it stands.
using StoppedProfiles = std::map<const TaperedBeam*, std::shared_ptr<const FlexibilityProfile>>;

/// At so many times its loads a mechanism in space that is stopped in a state buckles elastically,
/// at most `most`, beyond which it is not looked; nothing where it cannot be stopped and hold the
/// beam: where forces move it, at a dead point, or where a body is free to turn.
///
/// The beams of the case are elastic, of exact taper, torsion and shear, and so are its rods by
/// their section, of which those that bow alone (`ElasticMember::bows_alone`) and those without
/// mass only stretch; other bodies are far stiffer bars along the line between the farthest two of
/// their places, of even mass, drivers and joints without a stiffness are as rigid. Friction holds
/// nothing. Springs act as they are, with the force in them; another rod between two places is a
/// bar. What presses any of them counts
/// (`frame::Statics::critical_factor`): so a boom that a cylinder holds in the plane in which it
/// luffs buckles across it as a cantilever. `diagram`: of the verified beam then. Places
/// beside the line of a body follow its turns; the second order of these levers is left out.
/// `profiles`: of its beams, found when first asked for.
std::optional<double> critical_factor_in_space(const Project& project, const spatial::Chain& chain,
                                               const spatial::State& state,
                                               const CutForceDiagram& diagram, double most,
                                               StoppedProfiles& profiles);

}  // namespace boxbeam
