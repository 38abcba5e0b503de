#pragma once

#include <string>
#include <vector>

#include "beam_writer.hpp"
#include "draw.hpp"
#include "random_case.hpp"

/// Parts of random cases.
namespace oracle {

/// Material, strength and fatigue with its details; `situations`: those say how often.
std::string demands(Draw& draw, const BeamWriter& beam, double length, bool situations);

/// A function of time for a force of a size [N], of a period [s]: constant, harmonic or a table.
std::string law(Draw& draw, RandomCase& of, double size, double period, bool must_change);

/// Situations that change some key, and changes between and sequences of them.
std::string situations(Draw& draw, const std::string& key, const std::vector<std::string>& values);

/// What holds, stiffens and loads the beam by parts of its own, of other steels, under partial
/// factors that are not the usual ones.
void add_parts(Draw& draw, const BeamWriter& beam, RandomCase& of);

/// A beam under forces of a file.
BeamWriter write_given_loads(Draw& draw, RandomCase& of);
/// A beam that is pressed so that it may buckle, under forces that do not change.
void write_strut(Draw& draw, RandomCase& of);
/// A boom in space that luffs on a rod, a cylinder or a body.
BeamWriter write_luffing(Draw& draw, RandomCase& of);
/// A beam on two supports under load cases that combine.
BeamWriter write_frame(Draw& draw, RandomCase& of);

}  // namespace oracle
