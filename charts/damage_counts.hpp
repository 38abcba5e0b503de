#pragma once

#include <cstddef>
#include <vector>

#include "boxbeam/fatigue/rainflow.hpp"
#include "boxbeam/fatigue/sn_curve.hpp"

/// Damage of random histories, counted in one way and another.
namespace boxbeam::charts {

using Samples = std::vector<double>;

constexpr std::size_t sample_count = std::size_t{1} << 17U;
constexpr double largest_range = 240e6;  ///< of every history [Pa]

/// Noise of many frequencies, the same on every machine.
Samples wide_band();
/// About a frequency of 0.05 per sample, damped by 1 % of the critical.
Samples narrow_band();
/// Three harmonics whose frequencies have no common period.
Samples harmonics();

SnCurve category_100();
/// range^m N = constant, without end.
SnCurve one_slope(double m);

/// How many cycles, halves as one, the texts count in a history. Source: ASTM E1049-85, 5.4.4.
double cycles_of(const Samples& samples);

/// The truth: every cycle by itself, counted by a stack as the texts have it, summed in long
/// double.
double exact_damage(const Samples& samples, const SnCurve& curve);
/// The same in double.
double stack_damage(const Samples& samples, const SnCurve& curve);
/// As the program does it: counted in chunks as they come, each cycle's damage by itself.
double streamed_damage(const Samples& samples, const SnCurve& curve, std::size_t chunk,
                       const RainflowKernels& kernels);
double damage_in_memory(const Samples& samples, const SnCurve& curve);
/// Each chunk a history of its own: what spans two of them is lost.
double separate_damage(const Samples& samples, const SnCurve& curve, std::size_t chunk);

/// What stands for the cycles of a class.
enum class Stands { middle, upper_edge, mean };

/// Cycles gathered in equal classes of range first, damage once per class.
double damage_in_classes(const Samples& samples, const SnCurve& curve, int classes, Stands stands);
/// Samples moved to the middle of their class of stress first, as a from-to matrix needs it.
double damage_from_matrix(const Samples& samples, const SnCurve& curve, int classes);

}  // namespace boxbeam::charts
