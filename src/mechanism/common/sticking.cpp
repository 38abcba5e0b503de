#include "boxbeam/mechanism/common/sticking.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <optional>

#include "boxbeam/core/error.hpp"

namespace boxbeam {
namespace {

constexpr double round_off_of_forces = 1e-12;

/// Of one try: the contacts' slips with their forces.
struct TriedSlips {
  Sticking of;
  Eigen::VectorXd rate;
  std::size_t sliding = 0;
};

[[noreturn]] void refuse_slips(const std::string& why, const std::vector<std::string>& names,
                               double time) {
  throw AnalysisError({why, fmt::format("joint {}", fmt::join(names, ", joint ")), time});
}

/// Whether contacts that were tried obey the law of standing ones.
bool obeys_coulomb(const std::vector<Friction>& laws, const FrictionResponse& response,
                   const std::vector<std::size_t>& standing, const TriedSlips& tried) {
  constexpr double round_off_of_rates = 1e-9;
  const Eigen::VectorXd load = response.load_0 + response.load * tried.of.forces;
  for (const std::size_t contact : standing) {
    const auto j = static_cast<Eigen::Index>(contact);
    const double slip = static_cast<double>(tried.of.slips[contact]);
    if (slip == 0.0) {
      const double most =
          laws[contact].coulomb * pressure_of(laws[contact], load.segment<6>(6 * j));
      if (std::abs(tried.of.forces[j]) > most) return false;
    } else {
      const double size =
          std::abs(response.rate_0[j]) +
          response.rate.row(j).cwiseAbs().dot(tried.of.forces.cwiseAbs().transpose());
      if (slip * tried.rate[j] < -round_off_of_rates * size) return false;
    }
  }
  return true;
}

/// The one state of standing contacts that agrees with Coulomb's law of one coefficient; of several
/// that are the same to round-off that in which fewest slide.
TriedSlips only_state_of_contacts(const std::vector<Friction>& laws,
                                  const FrictionResponse& response, const std::vector<Slip>& known,
                                  const std::vector<std::size_t>& standing,
                                  const std::vector<std::string>& names, double time) {
  constexpr double same = 1e-6;
  std::vector<std::string> of_standing;
  for (const std::size_t contact : standing) of_standing.push_back(names[contact]);
  std::vector<TriedSlips> found;
  std::size_t tries = 1;
  for (std::size_t i = 0; i < standing.size(); ++i) tries *= 3;
  for (std::size_t number = 0; number < tries; ++number) {
    TriedSlips tried{{known, {}}, {}, 0};
    std::size_t rest = number;
    for (const std::size_t contact : standing) {
      constexpr Slip ways[] = {Slip::none, Slip::ahead, Slip::back};
      tried.of.slips[contact] = ways[rest % 3];
      if (rest % 3 != 0) ++tried.sliding;
      rest /= 3;
    }
    const std::optional<Eigen::VectorXd> forces = solve_friction(laws, tried.of.slips, response);
    if (!forces) continue;
    tried.of.forces = *forces;
    tried.rate = response.rate_0 + response.rate * *forces;
    if (obeys_coulomb(laws, response, standing, tried)) found.push_back(std::move(tried));
  }
  if (found.empty()) {
    refuse_slips(
        "neither sticking nor sliding agrees with Coulomb's law there: friction locks (Painleve's "
        "paradox); lower the friction coefficient, guide the slider otherwise, or give a creep "
        "velocity, which smooths the friction",
        of_standing.empty() ? names : of_standing, time);
  }
  const auto fewest = std::min_element(
      found.begin(), found.end(),
      [](const TriedSlips& a, const TriedSlips& b) { return a.sliding < b.sliding; });
  for (const TriedSlips& other : found) {
    const double largest =
        fewest->of.forces.lpNorm<Eigen::Infinity>() + other.of.forces.lpNorm<Eigen::Infinity>();
    if ((other.of.forces - fewest->of.forces).lpNorm<Eigen::Infinity>() <= same * largest) continue;
    const double fastest =
        other.rate.lpNorm<Eigen::Infinity>() +
        (response.rate.cwiseAbs() * other.of.forces.cwiseAbs()).lpNorm<Eigen::Infinity>();
    const bool moves_alike =
        (other.rate - fewest->rate).lpNorm<Eigen::Infinity>() <= same * fastest;
    refuse_slips(
        moves_alike
            ? "contacts stick there that hold the same movement, and how they share the friction "
              "that takes is not determined by rigid bodies; let one of them alone rub, or give "
              "a creep velocity, which smooths the friction"
            : "more than one state of sticking and sliding agrees with Coulomb's law there "
              "(Painleve's paradox); lower the friction coefficient, guide the slider "
              "otherwise, or give a creep velocity, which smooths the friction",
        of_standing, time);
  }
  return *fewest;
}

}  // namespace

std::vector<StickingContact> sticking_contacts(const std::vector<FirstSlip>& first, double begin,
                                               const std::vector<SlipChange>& changes) {
  std::vector<StickingContact> contacts;
  for (const FirstSlip& of : first) {
    StickingContact& contact = contacts.emplace_back();
    contact.joint = of.joint;
    if (of.slip == Slip::none) contact.spans.push_back({begin, {}});
    for (const SlipChange& change : changes) {
      if (change.joint != of.joint) continue;
      if (change.from == Slip::none && !contact.spans.empty())
        contact.spans.back().until = change.time;
      if (change.to == Slip::none) contact.spans.push_back({change.time, {}});
    }
  }
  return contacts;
}

std::vector<FirstSlip> first_slips_of(const std::vector<Friction>& laws,
                                      const std::vector<std::string>& names,
                                      const std::vector<Slip>& slips) {
  std::vector<FirstSlip> first;
  for (std::size_t j = 0; j < slips.size(); ++j)
    if (can_stick(laws[j])) first.push_back({names[j], slips[j]});
  return first;
}

std::string to_text(const StickingContact& contact) {
  if (contact.spans.empty()) return fmt::format("{} never sticks", contact.joint);
  constexpr std::size_t most_named = 20;
  std::vector<std::string> spans;
  for (const StickingSpan& span : contact.spans) {
    if (spans.size() == most_named) {
      spans.push_back("...");
      break;
    }
    spans.push_back(span.until ? fmt::format("{:.6g} s to {:.6g} s", span.from, *span.until)
                               : fmt::format("from {:.6g} s on", span.from));
  }
  const std::size_t times = contact.spans.size();
  return fmt::format("{} sticks {}: {}", contact.joint,
                     times == 1 ? "once" : fmt::format("{} times", times), fmt::join(spans, ", "));
}

std::vector<double> times_of(const std::vector<SlipChange>& changes) {
  std::vector<double> times;
  for (const SlipChange& change : changes) times.push_back(change.time);
  return times;
}

Sticking decide_sticking(const std::vector<Friction>& laws, const FrictionResponse& response,
                         const std::vector<char>& stands, const std::vector<std::string>& names,
                         double time) {
  constexpr std::size_t most_standing = 8;
  std::vector<Slip> slips(laws.size(), Slip::none);
  std::vector<Friction> now = laws;
  std::vector<std::size_t> standing;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    if (!can_stick(laws[j])) continue;
    if (stands[j] == 0) {
      slips[j] = slip_of(response.velocity[static_cast<Eigen::Index>(j)]);
      continue;
    }
    standing.push_back(j);
    now[j].coulomb = static_coefficient_of(laws[j]);
  }
  if (standing.size() > most_standing) {
    refuse_slips(fmt::format("{} contacts with dry friction stand at once, more than can be "
                             "decided; give those that matter least a creep velocity, which "
                             "smooths their friction",
                             standing.size()),
                 names, time);
  }
  while (true) {
    const TriedSlips state = only_state_of_contacts(now, response, slips, standing, names, time);
    // What slides has less friction than what stood, if mu is below mu_s.
    bool less = false;
    std::vector<std::size_t> still;
    for (const std::size_t j : standing) {
      if (state.of.slips[j] == Slip::none) {
        still.push_back(j);
        continue;
      }
      slips[j] = state.of.slips[j];
      less = less || now[j].coulomb > laws[j].coulomb;
      now[j].coulomb = laws[j].coulomb;
    }
    if (!less) return state.of;
    standing = std::move(still);
  }
}

bool slips_go_on(const std::vector<Friction>& laws, const std::vector<Slip>& slips,
                 const Eigen::VectorXd& velocity, const Eigen::VectorXd& forces,
                 const Eigen::VectorXd& pressure, double rest) {
  for (std::size_t contact = 0; contact < laws.size(); ++contact) {
    if (!can_stick(laws[contact])) continue;
    const auto j = static_cast<Eigen::Index>(contact);
    const double most = static_coefficient_of(laws[contact]) * pressure[j];
    switch (slips[contact]) {
      case Slip::none:
        if (std::abs(forces[j]) > (1.0 + round_off_of_forces) * most) return false;
        break;
      case Slip::ahead:
      case Slip::back:
        if (static_cast<double>(slips[contact]) * velocity[j] < -rest) return false;
        break;
    }
  }
  return true;
}

std::vector<char> standing_contacts(const std::vector<Friction>& laws,
                                    const std::vector<Slip>& slips, const Eigen::VectorXd& velocity,
                                    double rest) {
  std::vector<char> stands(laws.size(), 0);
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const bool stuck = !slips.empty() && slips[j] == Slip::none;
    const bool slow = std::abs(velocity[static_cast<Eigen::Index>(j)]) <= rest;
    stands[j] = can_stick(laws[j]) && (stuck || slow) ? 1 : 0;
  }
  return stands;
}

Eigen::VectorXd holding_impulses(const FrictionResponse& response, const std::vector<char>& held) {
  std::vector<Eigen::Index> rows;
  for (std::size_t j = 0; j < held.size(); ++j)
    if (held[j] != 0) rows.push_back(static_cast<Eigen::Index>(j));
  Eigen::VectorXd impulses = Eigen::VectorXd::Zero(response.velocity.size());
  if (rows.empty()) return impulses;
  const Eigen::MatrixXd rate = response.rate(rows, rows);
  const Eigen::VectorXd velocity = response.velocity(rows);
  const Eigen::VectorXd of_rows = rate.completeOrthogonalDecomposition().solve(-velocity);
  for (std::size_t i = 0; i < rows.size(); ++i)
    impulses[rows[i]] = of_rows[static_cast<Eigen::Index>(i)];
  return impulses;
}

std::vector<SlipChange> changes_between(const std::vector<std::string>& names,
                                        const std::vector<Slip>& before,
                                        const std::vector<Slip>& after, double time) {
  std::vector<SlipChange> changes;
  for (std::size_t j = 0; j < before.size(); ++j)
    if (after[j] != before[j]) changes.push_back({time, names[j], before[j], after[j]});
  return changes;
}

void note_changes(std::vector<SlipChange>& changes, const std::vector<SlipChange>& found,
                  double apart) {
  for (const SlipChange& change : found) {
    const bool known = std::any_of(changes.begin(), changes.end(), [&](const SlipChange& other) {
      return other.joint == change.joint && other.to == change.to &&
             std::abs(other.time - change.time) <= apart;
    });
    if (!known) changes.push_back(change);
  }
  std::stable_sort(changes.begin(), changes.end(),
                   [](const SlipChange& a, const SlipChange& b) { return a.time < b.time; });
}

}  // namespace boxbeam
