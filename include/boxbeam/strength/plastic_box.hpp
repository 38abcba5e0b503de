#pragma once

#include <array>
#include <optional>

#include "boxbeam/strength/effective_box.hpp"
#include "boxbeam/strength/effective_path.hpp"

namespace boxbeam {

/// What a web is used by bending and shear together, and by which rule.
struct WebInteraction {
  double use = 0.0;
  double share = 0.0;   ///< of 7.1(1) in it, the rest being 7.1(5)
  double factor = 0.0;  ///< on all loads, at which 7.1(1) and clauses 4 and 5 end
  Moment moment;        ///< by which 7.1(1) is used most: with or without the shift of N
};

/// A box, or a path like an I, that yields all over when it bends about y: of its compressed flange
/// what works, its webs whole, stiffeners left out.
///
///     M/M_N + (1 - M_f/M_N) (2 V/V_bw - 1)^2 <= 1,  V > V_bw/2
///
/// M_N  plastic moment with N, w = N + F_c - F_t the force of the webs, F of the flanges, W of webs
///      that yield whole: F_c a_c + F_t a_t + w a_w + W h_w/4 (1 - (w/W)^2), arms from the gross
///      centroid, at which N acts
/// M_f  of the flanges alone: min(F_c, F_t) (a_c + a_t) (1 - |N|/(F_c + F_t))
///
/// Never below clause 4 nor clause 5 (M < M_f), nor above 7.1(5). Where a web is compressed all
/// over, by elastic or by plastic stress, and where the box bends about z as well, 7.1(5) holds;
/// what of one edge a fifth of the other's stress, or of the web, pulls yet, leads over to it, so
/// that nothing jumps. Source: EN 1993-1-5:2006, 7.1(1), (4), (5), 5.4(2).
class PlasticBox {
 public:
  explicit PlasticBox(const EffectiveBox& box);

  /// Of a path of upright webs between two levels and flanges there, as an I or a channel; nothing
  /// of others. What lies in no clear width is left out.
  static std::optional<PlasticBox> of_path(const EffectivePath& path);

  /// `corner`: the place used most under these cut forces, eta_1 its use with gamma_M0, eta_3 =
  /// V/V_bw,Rd of the web.
  WebInteraction web_under(const CutForces& cut, const SectionUse& corner, double gamma_M0,
                           double eta_1, double eta_3) const;

 private:
  PlasticBox() = default;
  friend Traced derive_web_interaction(Derivation&, const PlasticBox&, const WebInteraction&,
                                       const CutForces&, double, const Traced&, const Traced&);
  /// One sense of bending.
  struct Sense {
    Force compressed, stretched;  ///< of flanges that yield
    Length arm_compressed, arm_stretched, arm_webs;
  };
  const Sense& sense_of(Moment moment) const { return senses_[moment < Moment{} ? 1 : 0]; }
  double pulled_share(Force N, Moment M, double factor) const;
  double factor_of(Force N, Moment M, double eta_1, double eta_3) const;

  std::array<Sense, 2> senses_;  ///< of M_y above and below zero
  Force webs_;
  Length depth_;
  Length centroid_;  ///< gross
  Area area_;        ///< gross
  SecondMoment inertia_;
  Length web_low_, web_high_;  ///< from the gross centroid
};

/// The factor of a web, step by step; `acting`: by what N and M are multiplied, partial factors.
Traced derive_web_interaction(Derivation& steps, const PlasticBox& box, const WebInteraction& of,
                              const CutForces& cut, double acting, const Traced& eta_1,
                              const Traced& eta_3);

}  // namespace boxbeam
