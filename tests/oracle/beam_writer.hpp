#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "draw.hpp"

namespace oracle {

enum class Family { box, tube, round, plate, nested };

/// Writes the sections and the beam of a case.
class BeamWriter {
 public:
  BeamWriter(Draw& draw, double length, double size, bool space)
      : draw_(draw), length_(length), space_(space) {
    const double which = draw.real(0, 1);
    family_ = which < 0.5    ? Family::box
              : which < 0.65 ? Family::tube
              : which < 0.75 ? Family::round
              : which < 0.85 ? Family::plate
                             : Family::nested;
    width_ = round_mm(size * draw.real(0.5, 1.2));
    size_ = size;
    const double slender = draw.real(10.0, 30.0);
    top_ = round_mm(std::max(0.005, width_ / slender));
    bottom_ = draw.chance(0.4) ? round_mm(top_ * draw.real(0.7, 1.6)) : top_;
    left_ = round_mm(std::max(0.004, size * draw.real(0.03, 0.07)));
    right_ = draw.chance(0.25) ? round_mm(left_ * draw.real(0.7, 1.8)) : left_;
    if (draw.chance(0.1)) top_ = bottom_ = round_mm(draw.real(0.026, 0.045));
    bars_ = family_ == Family::box && draw.chance(0.25) ? draw.whole(1, 2) : 0;
    bar_on_web_ = draw.chance(0.3);
    throat_ =
        family_ == Family::box && draw.chance(0.4) ? round_mm(left_ * draw.real(0.4, 0.9)) : 0;
    write_segments();
  }

  std::string sections, segments;
  double modulus() const { return modulus_; }
  Family family() const { return family_; }
  bool has_stiffeners() const { return bars_ > 0; }
  double length() const { return length_; }
  bool in_space() const { return space_; }
  const std::vector<double>& borders() const { return borders_; }
  bool has_webs() const { return family_ != Family::round && family_ != Family::plate; }

  /// Holes in boxes and tubes, away from the ends.
  std::string holes() {
    if (family_ != Family::box && family_ != Family::tube) return "";
    if (bars_ > 0 || !draw_.chance(0.3)) return "";
    const double at = draw_.chance(0.3) && borders_.size() > 2
                          ? borders_[1]
                          : round_mm(length_ * draw_.real(0.1, 0.9));
    const bool webs = space_ ? draw_.chance(0.6) : draw_.chance(0.75);
    const double clear = webs ? least_height_ - top_ - bottom_ : width_ - left_ - right_;
    const double diameter = round_mm(clear * draw_.real(0.15, 0.4));
    if (diameter < 0.005) return "";
    const double level = webs && draw_.chance(0.3) ? round_mm(0.15 * clear) : 0.0;
    return fmt::format(
        "\n[[beam.holes]]\nname = \"access\"\ndiameter = {}\nstation = {}\nthrough = \"{}\"\n"
        "{} = [{}]\nconcentration = \"{}\"\n",
        mm(diameter), m(at), webs ? "webs" : "flanges", webs ? "levels" : "offsets", mm(level),
        webs ? "in-plane bending" : "membrane tension");
  }

 private:
  struct Profile {
    double height, width, top, bottom, left, right;
  };

  Profile profile() {
    Profile of{round_mm(size_ * draw_.real(0.6, 1.7)), width_, top_, bottom_, left_, right_};
    if (draw_.chance(0.2)) of.width = round_mm(width_ * draw_.real(0.8, 1.2));
    // Plates of a growing thickness pass the steps of the yield strength.
    if (draw_.chance(0.1)) of.top = round_mm(top_ * draw_.real(0.8, 1.3));
    if (draw_.chance(0.1)) of.left = round_mm(left_ * draw_.real(0.8, 1.3));
    if (family_ == Family::plate) of.width = round_mm(std::max(0.012, size_ * 0.3));
    // Clear height between the flanges.
    of.height = std::max(of.height, 2.0 * (of.top + of.bottom));
    least_height_ = std::min(least_height_, of.height);
    return of;
  }

  std::string written(const std::string& name, const Profile& p) {
    std::string text = fmt::format("\n[sections.{}]\n", name);
    const double wall = std::max(p.left, 0.004);
    switch (family_) {
      case Family::box: {
        text += fmt::format(
            "kind = \"box\"\nwidth = {}\nheight = {}\ntop_flange = {}\nbottom_flange = {}\n"
            "left_web = {}\nright_web = {}\n",
            mm(p.width), mm(p.height), mm(p.top), mm(p.bottom), mm(p.left), mm(p.right));
        if (throat_ > 0.0) text += fmt::format("seam_throat = {}\n", mm(throat_));
        for (int i = 0; i < bars_; ++i) {
          const bool web = bar_on_web_ && i == 0;
          // No bar reaches another.
          const double room = std::min({0.2 * size_, 0.4 * (p.width - p.left - p.right) - left_,
                                        0.4 * (p.height - p.top - p.bottom)});
          const double depth = round_mm(std::min(std::max(0.012, 6.0 * left_), room));
          text += fmt::format(
              "[[sections.{}.stiffeners]]\non = \"{}\"\nat = {}\ndepth = {}\nthickness = {}\n",
              name, web ? "left web" : (i == 0 ? "top flange" : "bottom flange"),
              mm(web ? 0.1 * least_possible() : 0.0), mm(depth), mm(left_));
        }
        break;
      }
      case Family::tube:
        text += fmt::format("kind = \"rectangular tube\"\nwidth = {}\nheight = {}\nwall = {}\n",
                            mm(p.width), mm(p.height), mm(wall));
        break;
      case Family::round:
        text += fmt::format("kind = \"round tube\"\ndiameter = {}\nwall = {}\n", mm(p.height),
                            mm(wall));
        break;
      case Family::plate:
        text +=
            fmt::format("kind = \"plate\"\nwidth = {}\nheight = {}\n", mm(p.width), mm(p.height));
        break;
      case Family::nested: {
        text +=
            fmt::format("kind = \"nested\"\nouter = \"{0}_outer\"\ninner = \"{0}_inner\"\n", name);
        text += fmt::format(
            "\n[sections.{}_outer]\nkind = \"box\"\nwidth = {}\nheight = {}\ntop_flange = {}\n"
            "bottom_flange = {}\nleft_web = {}\nright_web = {}\n",
            name, mm(p.width), mm(p.height), mm(p.top), mm(p.bottom), mm(p.left), mm(p.right));
        const double room =
            std::min(p.width - p.left - p.right, p.height - p.top - p.bottom) - 0.012;
        text += fmt::format("\n[sections.{}_inner]\n", name);
        if (inner_round_) {
          text += fmt::format("kind = \"round tube\"\ndiameter = {}\nwall = {}\n", mm(0.8 * room),
                              mm(std::max(0.004, 0.06 * room)));
        } else {
          text += fmt::format("kind = \"box\"\nwidth = {}\nheight = {}\nflange = {}\nweb = {}\n",
                              mm(0.8 * room), mm(0.7 * room), mm(std::max(0.004, 0.06 * room)),
                              mm(std::max(0.004, 0.05 * room)));
        }
        break;
      }
    }
    return text;
  }

  double least_possible() const { return 0.6 * size_; }

  void write_segments() {
    inner_round_ = draw_.chance(0.5);
    const int count = draw_.whole(1, 4);
    borders_ = {0.0};
    for (int i = 1; i < count; ++i)
      borders_.push_back(round_mm(length_ * (i + draw_.real(-0.3, 0.3)) / count));
    borders_.push_back(length_);
    int number = 0;
    const auto add = [&](const Profile& p) {
      const std::string name = fmt::format("A{}", ++number);
      sections += written(name, p);
      return name;
    };
    Profile at = profile();
    std::string name = add(at);
    for (int i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      if (i > 0 && draw_.chance(0.25)) {
        at = profile();
        name = add(at);
      }
      const Profile first = at;
      std::string end = name;
      if (draw_.chance(0.65)) {
        at = profile();
        end = add(at);
      }
      segments += fmt::format("\n[[beam.segments]]\nname = \"part {}\"\nlength = {}\n", i + 1,
                              mm(borders_[k + 1] - borders_[k]));
      segments += name == end ? fmt::format("section = \"{}\"\n", name)
                              : fmt::format("from = \"{}\"\nto = \"{}\"\n", name, end);
      name = end;
      for (const Profile& p : {first, at}) {
        const double W =
            family_ == Family::plate   ? p.width * p.height * p.height / 6.0
            : family_ == Family::round ? 0.78 * p.height * p.height * std::max(p.left, 0.004)
            : family_ == Family::tube
                ? p.height * std::max(p.left, 0.004) * (p.width + 0.33 * p.height)
                : p.height *
                      (0.5 * (p.top + p.bottom) * p.width + 0.17 * (p.left + p.right) * p.height);
        modulus_ = modulus_ == 0.0 ? W : 0.5 * (modulus_ + W);
      }
    }
  }

  Draw& draw_;
  double length_, size_ = 0.0, width_ = 0.0;
  bool space_;
  Family family_ = Family::box;
  double top_ = 0.0, bottom_ = 0.0, left_ = 0.0, right_ = 0.0, throat_ = 0.0;
  int bars_ = 0;
  bool bar_on_web_ = false, inner_round_ = false;
  double least_height_ = 1e9, modulus_ = 0.0;
  std::vector<double> borders_;
};

}  // namespace oracle
