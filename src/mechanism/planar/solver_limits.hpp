#pragma once

/// Limits of the solver of instants, all of scaled quantities: lengths by the mechanism's size.
namespace boxbeam::planar::limits {

/// A scaled pivot at which no digit of a velocity is left: near a dead point pivots fall with the
/// root of the distance to it, and the error of velocities grows as round-off over that distance.
inline constexpr double no_digit_left = 1e-7;
/// The same for the smallest singular value of least squares, whose square ends in round-off.
inline constexpr double lost_in_squares = 3e-7;
/// Round-off of a coordinate, relative.
inline constexpr double round_off = 1e-15;
/// Residual of redundant equations that agree.
inline constexpr double still_closed = 1e-9;
/// Inverse of the condition next to a change point.
inline constexpr double near_change_point = 1e-5;
/// A scaled pivot at a start that may be meant as a change point.
inline constexpr double near_dead_point = 1e-6;
/// Starts tried beside the sketch for a wanted branch.
inline constexpr int other_starts = 256;
/// Halvings of a time step when a branch is followed.
inline constexpr int deepest_split = 24;
/// Steps by halving in all that a solver follows, times the coordinates of the mechanism: some ten
/// seconds.
inline constexpr double most_split_work = 2e7;
/// What a change of position may differ from its rates, relative.
inline constexpr double smooth_enough = 0.02;

}  // namespace boxbeam::planar::limits
