#include "boxbeam/project/attachment_welds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "boxbeam/project/plate_detail.hpp"
#include "boxbeam/strength/effective_box.hpp"

namespace boxbeam {
namespace {

/// Beside the nominal stress: a structural one, or that in a throat, is of the beam's own detail.
double own_concentration_of(const BeamDetail& of_beam) {
  const bool nominal =
      of_beam.detail.where == StressPlace::gross || of_beam.detail.where == StressPlace::net;
  return nominal ? std::max(1.0, of_beam.stress_factor) : 1.0;
}

bool have_one_shape(const SnCurve& a, const SnCurve& b) {
  return a.reference_cycles == b.reference_cycles && a.cut_off == b.cut_off &&
         a.constant_amplitude_limit == b.constant_amplitude_limit &&
         std::equal(a.branches.begin(), a.branches.end(), b.branches.begin(), b.branches.end(),
                    [](const SnBranch& one, const SnBranch& other) {
                      return one.slope == other.slope && one.until == other.until;
                    });
}

class Attachments {
 public:
  Attachments(const TaperedBeam& beam, const BeamDetail& of_beam, const AttachmentDetails& given)
      : beam_(&beam), given_(&given), concentration_(own_concentration_of(of_beam)) {
    for (const Diaphragm& of : beam.diaphragms) add_diaphragm(of);
    for (std::size_t i = 0; i < beam.segments.size(); ++i) add_flats(i);
  }

  std::vector<AttachmentWeld> welds;

 private:
  AttachmentWeld& add(Length from, Length to, const std::optional<Detail>& given,
                      const Detail& by_row, std::string assumed) {
    AttachmentWeld& weld = welds.emplace_back();
    weld.detail.from = from;
    weld.detail.to = to;
    weld.detail.stress_factor = concentration_;
    weld.detail.detail = given ? *given : by_row;
    if (!given) weld.detail.assumed = std::move(assumed);
    return weld;
  }

  void add_diaphragm(const Diaphragm& of) {
    const Length longest = si<Length>(80e-3);
    const bool said = of.throat > Length{};
    const Length leg = said ? Length(std::numbers::sqrt2 * of.throat) : of.thickness;
    const Length toes = of.thickness + 2.0 * leg;
    const Length between_toes = std::min(toes, longest);
    const bool path = std::holds_alternative<ThinWalled>(section_at(*beam_, {of.s}).outer);
    add(of.s, of.s, given_->diaphragms,
        detail_of_row(path ? "8.4/7" : "8.4/8", "weld of a diaphragm", between_toes),
        fmt::format("fillets with legs {}, {:.6g} mm between their toes{}",
                    said ? "of their throat" : "as long as it is thick", 1e3 * toes.value(),
                    toes > longest ? ", beyond the 80 mm at which their row ends" : ""));
  }

  static const std::vector<Stiffener>& flats_of(const Section& section) {
    static const std::vector<Stiffener> none;
    const auto* const box = std::get_if<Box>(&section.outer);
    return box == nullptr ? none : box->stiffeners;
  }

  /// The flat of a section that goes on from one on the other side of the border of two segments.
  static const Stiffener* same_in(const Section& section, const Stiffener& bar) {
    const std::vector<Stiffener>& flats = flats_of(section);
    const auto found = std::find_if(flats.begin(), flats.end(), [&](const Stiffener& other) {
      return other.plate == bar.plate && abs(other.place - bar.place) <= bar.thickness;
    });
    return found == flats.end() ? nullptr : &*found;
  }

  /// Where a flat that leaves a segment backwards or forwards ends.
  Length end_of(std::size_t segment, const Stiffener& bar, bool forwards) const {
    const Stiffener* at = &bar;
    for (std::size_t i = segment;;) {
      const bool last = forwards ? i + 1 == beam_->segments.size() : i == 0;
      const Segment& here = beam_->segments[i];
      const Length border = forwards ? here.end() : here.start;
      if (last) return border;
      i = forwards ? i + 1 : i - 1;
      const Segment& next = beam_->segments[i];
      const Section& near = forwards ? next.from : next.to;
      const Stiffener* const on = same_in(near, *at);
      if (on == nullptr) return border;
      // The same flat at the far end of that segment.
      const auto number = on - flats_of(near).data();
      at = &flats_of(forwards ? next.to : next.from)[static_cast<std::size_t>(number)];
    }
  }

  void add_flats(std::size_t i) {
    const Segment& segment = beam_->segments[i];
    const std::vector<Stiffener>&from = flats_of(segment.from), &to = flats_of(segment.to);
    for (std::size_t k = 0; k < from.size(); ++k) {
      const BoxPlate plate = from[k].plate;
      AttachmentWeld& along =
          add(segment.start, segment.end(), given_->flats,
              detail_of_row("8.2/5", fmt::format("weld along a flat on the {}", to_text(plate))),
              "continuous fillets by hand");
      const std::string name = fmt::format("stiffener {}", k + 1);
      along.flat = FlatLine{name + " weld", plate, from[k].place, to[k].place};
      const Length first = end_of(i, from[k], false), last = end_of(i, to[k], true);
      if (first == segment.start)
        add_end({name + " start", plate, from[k].place, from[k].place}, first, last - first);
      if (last == segment.end())
        add_end({name + " end", plate, to[k].place, to[k].place}, last, last - first);
    }
  }

  void add_end(FlatLine flat, Length s, Length length) {
    // The plates of the beam end there as well.
    if (s == Length{} || s == beam_->length()) return;
    AttachmentWeld& end = add(
        s, s, given_->flat_ends,
        detail_of_row("8.4/1", fmt::format("end of a flat on the {}", to_text(flat.plate)), length),
        "cut off square");
    end.flat = std::move(flat);
  }

  const TaperedBeam* beam_;
  const AttachmentDetails* given_;
  double concentration_;
};

}  // namespace

double comparable_strength_of(const BeamDetail& of) {
  return strength_at(curve_of(of.detail), 2e6, Loading::spectrum).value() / of.stress_factor;
}

bool is_nowhere_stronger(const BeamDetail& of, const BeamDetail& other) {
  const SnCurve &a = of.detail.curve, &b = other.detail.curve;
  const double part = of.detail.size_factor / of.stress_factor;
  const double other_part = other.detail.size_factor / other.stress_factor;
  if (have_one_shape(a, b)) return part * a.reference <= other_part * b.reference;
  std::vector<double> cycles{1.0, 1e12};
  for (const SnCurve* const curve : {&a, &b}) {
    for (const SnBranch& branch : curve->branches)
      if (std::isfinite(branch.until)) cycles.push_back(branch.until);
    for (const std::optional<double>& limit : {curve->constant_amplitude_limit, curve->cut_off})
      if (limit) cycles.push_back(*limit);
  }
  const SnLine line(a), other_line(b);
  constexpr double rounded = 1.0 + 1e-12;
  return std::all_of(cycles.begin(), cycles.end(), [&](double at) {
    const auto holds = [&](Loading loading) {
      return part * line.strength_at(at, loading) <=
             rounded * other_part * other_line.strength_at(at, loading);
    };
    return holds(Loading::spectrum) && holds(Loading::constant_amplitude);
  });
}

std::vector<AttachmentWeld> attachment_welds_of(const TaperedBeam& beam, const BeamDetail& of_beam,
                                                const AttachmentDetails& given) {
  if (beam.segments.empty()) return {};
  return Attachments(beam, of_beam, given).welds;
}

bool may_govern(const FatigueInput& fatigue, const AttachmentWeld& weld) {
  const auto is_as_weak = [&](const BeamDetail& of) {
    const bool counts_as_much =
        !of.detail.compression_reduced || weld.detail.detail.compression_reduced;
    return !of.detail.in_plates && counts_as_much && is_nowhere_stronger(of, weld.detail);
  };
  bool elsewhere = false;  // some place there has a detail of its own
  for (const BeamDetail& of : fatigue.details) {
    if (of.to < weld.detail.from || of.from > weld.detail.to) continue;
    const bool all_of_it = of.from <= weld.detail.from && of.to >= weld.detail.to;
    if (all_of_it && of.on == DetailPlace::section && is_as_weak(of)) return false;
    elsewhere = true;
  }
  return elsewhere || !is_as_weak(fatigue.beam);
}

}  // namespace boxbeam
