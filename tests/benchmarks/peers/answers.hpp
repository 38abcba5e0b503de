#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// The library's side of the comparison with other programs: what boxbeam and Simbody say when
/// peers.py asks, a line of JSON for a line of JSON, and how long it took them.
namespace peers {

using Json = nlohmann::ordered_json;

/// The sledge rig: followed over its period, or found from a rough posture.
Json answer_sledge(const Json& request);
/// Force-driven benchmarks: the pendulum and the N-four-bar.
Json answer_free(const Json& request);
/// An elastic beam, clamped at its start and held across at its end.
Json answer_beam(const Json& request);

/// Draws charts and maps with their CSV files into a folder.
void draw(const Json& shown, const std::string& folder);

/// Processor time of this thread: what others do on the machine counts least here [s].
double processor_time();

}  // namespace peers
