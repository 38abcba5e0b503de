#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace boxbeam {

/// The last line of every script, by which a whole one is known.
inline constexpr const char* script_end = "unset multiplot";

/// Runs gnuplot on scripts NAME.gp of a folder, as many at a time as there are processors; each
/// must leave NAME.svg. As processes of their own, not through pipes: a pipe would hide that it
/// failed. The same script gives the same bytes. Throws OutputError where gnuplot is missing
/// (naming the package) or fails (its first words).
void run_gnuplot(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace boxbeam
