#include "boxbeam/study/design_space.hpp"

#include <Random123/philox.h>
#include <fmt/format.h>
#include <muParser.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <limits>
#include <numeric>

#include "boxbeam/core/error.hpp"
#include "boxbeam/study/written_quantity.hpp"

namespace boxbeam {
namespace {

using Philox = r123::Philox4x32;

Philox::ctr_type block_of(std::uint64_t seed, std::uint64_t sample, std::uint32_t variable,
                          std::uint32_t stream) {
  const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
  const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32U); };
  const Philox::ctr_type counter{{low(sample), high(sample), variable, stream}};
  const Philox::key_type key{{low(seed), high(seed)}};
  return Philox()(counter, key);
}

/// 64 bits as a number in the middle of one of 2^53 equal parts.
double between_0_and_1(std::uint32_t low, std::uint32_t high) {
  const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32U | low) >> 11U;
  return (static_cast<double>(bits) + 0.5) * 0x1.0p-53;
}

/// A permutation of as many numbers, by the seed and the variable.
std::vector<std::uint32_t> permutation(std::uint64_t seed, std::size_t count,
                                       std::uint32_t variable) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::size_t i = count; i > 1; --i) {
    const Philox::ctr_type bits = block_of(seed, i, variable, 1);
    const auto other =
        static_cast<std::size_t>(between_0_and_1(bits[0], bits[1]) * static_cast<double>(i));
    std::swap(order[i - 1], order[std::min(other, i - 1)]);
  }
  return order;
}

/// How many values a variable takes by itself.
std::size_t count_of(const Variable& variable) {
  return std::max<std::size_t>(1, variable.values.size() + variable.words.size());
}

}  // namespace

void take_expressions(const Study& study, std::vector<Setting>& design) {
  for (std::size_t i = 0; i < design.size(); ++i) {
    const Variable& variable = study.variables[i];
    if (variable.expression.empty()) continue;
    try {
      mu::Parser parser;
      for (std::size_t k = 0; k < i; ++k)
        if (study.variables[k].words.empty())
          parser.DefineConst(study.variables[k].name, design[k].number);
      parser.SetExpr(variable.expression);
      design[i].number = parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
      throw AnalysisError({fmt::format("\"{}\": {}", variable.expression, error.GetMsg()),
                           "variable " + variable.name});
    }
    if (!std::isfinite(design[i].number))
      throw AnalysisError({fmt::format("\"{}\" has no finite value", variable.expression),
                           "variable " + variable.name});
  }
}

std::vector<Setting> design_of(const Study& study, const std::vector<double>& scattering) {
  std::vector<Setting> design(study.variables.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < design.size(); ++i) {
    const Variable& variable = study.variables[i];
    if (variable.distribution) design[i].number = scattering[next++];
    if (!variable.values.empty()) design[i].number = variable.values.front();
    if (!variable.words.empty()) design[i].word = variable.words.front();
  }
  take_expressions(study, design);
  return design;
}

double uniform_number(std::uint64_t seed, std::uint64_t sample, std::uint32_t variable) {
  const Philox::ctr_type bits = block_of(seed, sample, variable, 0);
  return between_0_and_1(bits[0], bits[1]);
}

DesignSpace::DesignSpace(const Study& study) : study_(&study) {
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    if (study.variables[i].distribution) scattering_.push_back(i);
  if (!scattering_.empty()) samples_ = study.samples;
  if (study.indices) block_ = scattering_.size() + 2;
  constexpr std::size_t most = 10'000'000'000;
  if (samples_ > most / block_)
    throw InputError(fmt::format("{}: the study has more than 1e10 designs", study.path),
                     "take fewer samples");
  size_ = samples_ * block_;
  for (std::size_t i = 0; i < study.variables.size(); ++i)
    if (study.variables[i].is_of_table && !of_table_) of_table_ = i;
  for (std::size_t i = 0; i < study.variables.size(); ++i) {
    const Variable& variable = study.variables[i];
    if (follows(i)) continue;
    if (count_of(variable) > most / size_)
      throw InputError(fmt::format("{}: the study has more than 1e10 designs", study.path),
                       "take fewer values or samples");
    size_ *= count_of(variable);
  }
  if (study.correlation.size() > 0) factor_ = study.correlation.llt().matrixL();
  if (study.sampling == Sampling::latin_hypercube)
    for (std::size_t k = 0; k < scattering_.size() * (study.indices ? 2 : 1); ++k)
      shares_.push_back(permutation(study.seed, samples_, static_cast<std::uint32_t>(k)));
}

bool DesignSpace::follows(std::size_t variable) const {
  return study_->variables[variable].is_of_table && variable != *of_table_;
}

/// Of so many variables, the share of all values that are below that of this sample.
std::vector<double> DesignSpace::independent_shares(std::size_t sample, std::size_t count) const {
  std::vector<double> shares(count);
  if (study_->sampling == Sampling::sobol) {
    // The library leaves the first point of the sequence out, which is zero.
    boost::random::sobol sequence(count);
    if (sample > 0) sequence.discard(static_cast<std::uintmax_t>(sample - 1) * count);
    for (double& share : shares) {
      constexpr double last = static_cast<double>(boost::random::sobol::max()) + 1.0;
      // In the middle of the smallest part that so many samples leave, so that no share is 0.
      share = (sample > 0 ? static_cast<double>(sequence()) / last : 0.0) +
              0.5 / static_cast<double>(samples_);
      share = std::min(share, 1.0 - 0x1.0p-53);
    }
  } else {
    for (std::size_t k = 0; k < count; ++k) {
      shares[k] = uniform_number(study_->seed, sample, static_cast<std::uint32_t>(k));
      if (!shares_.empty())
        shares[k] =
            (static_cast<double>(shares_[k][sample]) + shares[k]) / static_cast<double>(samples_);
    }
  }
  return shares;
}

/// Of each variable that scatters, by the number of the design among those that do.
std::vector<double> DesignSpace::shares_of(std::size_t sample) const {
  const std::size_t count = scattering_.size();
  if (study_->indices) {
    const std::vector<double> both = independent_shares(sample / block_, 2 * count);
    const std::size_t place = sample % block_;  // A, B, A with one variable of B
    std::vector<double> shares(both.begin(), both.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t k = 0; k < count; ++k)
      if (place == 1 || place == k + 2) shares[k] = both[count + k];
    return shares;
  }
  std::vector<double> shares = independent_shares(sample, count);
  if (factor_.size() > 0) {
    Eigen::VectorXd z(static_cast<Eigen::Index>(count));
    for (std::size_t k = 0; k < count; ++k)
      z[static_cast<Eigen::Index>(k)] = normal_quantile(shares[k]);
    z = factor_.triangularView<Eigen::Lower>() * z;
    for (std::size_t k = 0; k < count; ++k)
      shares[k] = std::clamp(normal_share_below(z[static_cast<Eigen::Index>(k)]),
                             std::numeric_limits<double>::min(), 1.0 - 0x1.0p-53);
  }
  return shares;
}

std::vector<Setting> DesignSpace::at(std::size_t index) const {
  std::vector<Setting> design(study_->variables.size());
  const std::size_t drawn = samples_ * block_;
  std::size_t rest = index / drawn;
  std::vector<std::size_t> places(design.size());
  for (std::size_t i = design.size(); i-- > 0;) {
    if (follows(i)) continue;
    const std::size_t count = count_of(study_->variables[i]);
    places[i] = rest % count;
    rest /= count;
  }
  for (std::size_t i = 0; i < design.size(); ++i) {
    const Variable& variable = study_->variables[i];
    const std::size_t place = places[follows(i) ? *of_table_ : i];
    if (!variable.words.empty())
      design[i].word = variable.words[place];
    else if (!variable.values.empty())
      design[i].number = variable.values[place];
  }
  if (!scattering_.empty()) {
    const std::vector<double> shares = shares_of(index % drawn);
    for (std::size_t k = 0; k < shares.size(); ++k) {
      const std::size_t i = scattering_[k];
      design[i].number = study_->variables[i].distribution->quantile(shares[k]);
    }
  }
  take_expressions(*study_, design);
  return design;
}

namespace {

/// A word as --set has it: "6.10" is one, not the number.
std::string set_as_text(const std::string& word) {
  const bool is_number = quantity_written_in(word) && word.find('"') == std::string::npos;
  return is_number ? '"' + word + '"' : word;
}

}  // namespace

std::vector<std::string> overrides_of(const Study& study, const std::vector<Setting>& design) {
  std::vector<std::string> set;
  for (std::size_t i = 0; i < design.size(); ++i) {
    const Variable& variable = study.variables[i];
    const std::string value = variable.words.empty()
                                  ? to_text(WrittenQuantity{design[i].number, variable.unit})
                                  : set_as_text(design[i].word);
    for (const std::string& key : variable.keys) set.push_back(fmt::format("{}={}", key, value));
  }
  return set;
}

}  // namespace boxbeam
