#include <Eigen/Core>

#include "boxbeam/report/json.hpp"
#include "document_fields.hpp"

namespace boxbeam::report {
namespace {

constexpr FieldNames signs{"+", "-", "0"};

const char* sign_text(int sign) { return sign > 0 ? "+" : (sign < 0 ? "-" : "0"); }

void put_branch(Fields& to, const std::vector<std::pair<std::string, int>>& branch) {
  std::vector<std::pair<std::string, std::string>> words;
  for (const auto& [loop, sign] : branch) words.emplace_back(loop, sign_text(sign));
  to.named_words({"branch", "sign of every loop"}, words, signs);
}

std::string name_of(const auto& item) { return item.name; }

void put_body(Fields& to, const BodyMotion& body) {
  to.number("x", "m", body.position.x());
  to.number("y", "m", body.position.y());
  to.number("angle", "rad", body.position.z());
  to.number("vx", "m/s", body.velocity.x());
  to.number("vy", "m/s", body.velocity.y());
  to.number("omega", "rad/s", body.velocity.z());
  to.number("ax", "m/s^2", body.acceleration.x());
  to.number("ay", "m/s^2", body.acceleration.y());
  to.number("alpha", "rad/s^2", body.acceleration.z());
}

void put_point(Fields& to, const PointMotion& point) {
  to.number("x", "m", point.position.x());
  to.number("y", "m", point.position.y());
  to.number("vx", "m/s", point.velocity.x());
  to.number("vy", "m/s", point.velocity.y());
  to.number("ax", "m/s^2", point.acceleration.x());
  to.number("ay", "m/s^2", point.acceleration.y());
}

void put_reaction(Fields& to, const JointReaction& reaction) {
  // What joints that repeat each other share is not determined: no number is invented.
  const auto known = [&](double value) {
    return reaction.unique ? std::optional(value) : std::nullopt;
  };
  to.text({"on", "the body that feels it"}, reaction.on);
  to.number_or_null("fx", "N", known(reaction.force.x()));
  to.number_or_null("fy", "N", known(reaction.force.y()));
  to.number_or_null("moment", "N m", known(reaction.moment));
  to.boolean({"unique", "else joints that repeat each other share it, and its numbers are null"},
             reaction.unique);
}

void put_chain(Fields& to, const ChainResult& chain) {
  to.named(
      {"steps", "carried up to each body"}, chain.steps,
      [](const ChainStepLoad& load) { return load.step; },
      [](Fields& of, const ChainStepLoad& load) {
        of.number("fx", "N", load.force.x());
        of.number("fy", "N", load.force.y());
        of.number_or_null(
            {"moment", "sum of J alpha, without force times arm; null for pieces of a body"}, "N m",
            load.moment);
      });
  to.number("sought_mass", "kg", chain.sought_mass);
}

}  // namespace

void put_state(Fields& to, const InstantResult& state) {
  to.number("time", "s", state.time);
  put_branch(to, state.branch);
  to.number({"residual", "largest error of the constraints"}, "1", state.residual);
  to.number("condition", "1", state.condition);
  to.number({"digits", "decimal digits of velocities that are left"}, "1", state.digits);
  to.named({"bodies", "centres of mass"}, state.bodies, name_of<BodyMotion>, put_body);
  to.named({"points", "body.point"}, state.points, name_of<PointMotion>, put_point);
  to.named(
      {"reactions", "world axes"}, state.reactions,
      [](const JointReaction& reaction) { return reaction.joint; }, put_reaction);
  to.object_or_null("newton_chain", state.chain, put_chain);
}

void put_state(Fields& to, const ChainInstant& state) {
  to.number("time", "s", state.time);
  // A chain without loops is explicit: it has no branch, and nothing is left open.
  put_branch(to, state.branch);
  to.number({"residual", "largest error of the loops' equations"}, "1", state.residual);
  to.number({"condition", "of the loops' equations"}, "1", state.condition);
  to.named("bodies", state.bodies, name_of<ChainBody>, [](Fields& of, const ChainBody& body) {
    of.vector("omega", "rad/s", body.omega);
    of.vector("alpha", "rad/s^2", body.alpha);
    of.vector({"position", "of its origin"}, "m", body.position);
    of.rows({"rotation", "by rows"}, "1", body.rotation);
    of.vector("inertia_force", "N", body.inertia_force);
    of.vector("inertia_moment", "N m", body.inertia_moment);
    of.vector("gyroscopic_moment", "N m", body.gyroscopic_moment);
  });
  to.named("points", state.points, name_of<ChainPoint>, [](Fields& of, const ChainPoint& point) {
    of.vector("position", "m", point.position);
    of.vector("velocity", "m/s", point.velocity);
    of.vector("acceleration", "m/s^2", point.acceleration);
  });
  to.named("joints", state.joints, name_of<ChainJoint>, [](Fields& of, const ChainJoint& joint) {
    of.text({"on", "the body that feels it"}, joint.on);
    of.vector("force", "N", joint.force);
    of.vector("moment", "N m", joint.moment);
    of.number_or_null({"drive", "force [N] or moment [N m] of the drive"}, "", joint.drive);
    of.number_or_null(
        {"friction",
         "along the axis, on the carried body or a closing joint's second one; a part "
         "of the force; null where nothing rubs"},
        "N", joint.friction);
    const auto part = [&](double DriverState::*value) {
      return joint.coordinate ? std::optional(*joint.coordinate.*value) : std::nullopt;
    };
    of.number_or_null({"coordinate", "angle [rad], shift or length [m]; null where fixed"}, "",
                      part(&DriverState::value));
    of.number_or_null({"rate", "of it"}, "", part(&DriverState::rate));
    of.boolean({"unique", "else joints that repeat each other share what it carries"},
               joint.unique);
  });
}

namespace {

void put_loops(Fields& to, const ChainLoops& loops) {
  to.texts({"closing", "joints that close loops"}, loops.closing);
  to.whole("equations", loops.equations, "1");
  to.whole({"freedoms", "coordinates that they decide"}, loops.freedoms, "1");
  to.whole({"repeating", "equations that others imply"}, loops.repeating, "1");
  to.texts({"not_unique", "joints that repeat each other: how they share their loads is not known"},
           loops.not_unique);
}

void put_hand_formula(Fields& to, const HandComparison& hand) {
  const auto plain = [&](const char* name, const Eigen::Vector3d& value) {
    to.numbers(name, "", std::span(value.data(), 3));
  };
  to.text("name", hand.formula.name);
  to.number("time", "s", hand.formula.time.value());
  to.word("quantity", to_text(hand.formula.quantity),
          {"omega", "alpha", "position", "velocity", "acceleration"});
  to.text("of", hand.of);
  to.texts("formula", hand.formula.formula);
  plain("value", hand.formula.value);
  plain("computed", hand.computed);
  plain("difference", hand.formula.value - hand.computed);
  to.text("note", hand.formula.note);
}

void put_sticking(Fields& to, const std::vector<StickingContact>& contacts) {
  to.named(
      {"sticking", "contacts with dry friction that can stick"}, contacts,
      [](const StickingContact& contact) { return contact.joint; },
      [](Fields& of, const StickingContact& contact) {
        of.list({"spans", "in which it does"}, "", contact.spans,
                [](Fields& span, const StickingSpan& each) {
                  span.number("from", "s", each.from);
                  span.number_or_null({"until", "null where it does to the end"}, "s", each.until);
                });
      });
}

}  // namespace

void put_motion(Fields& to, const AnyMotionResult& motion) {
  std::visit([&](const auto& of_kind) { put_motion(to, of_kind); }, motion);
}

void put_motion(Fields& to, const MotionResult& motion) {
  to.constant("schema", "boxbeam.motion/1");
  to.constant("kind", "planar");
  to.whole("degrees_of_freedom", motion.freedom.by_rank, "1");
  to.texts({"redundant", "joints that repeat others"}, motion.redundant);
  to.numbers({"change_points", "at which two branches cross"}, "s", motion.change_points);
  put_sticking(to, motion.sticking);
  to.list("states", "", motion.states,
          [](Fields& of, const InstantResult& state) { put_state(of, state); });
}

void put_motion(Fields& to, const ChainMotionResult& motion) {
  to.constant("schema", "boxbeam.motion/1");
  to.constant("kind", "spatial");
  to.text({"axes", "in which vectors are given: world, or a body"}, motion.axes);
  to.whole("degrees_of_freedom", motion.driven + motion.forced, "1");
  to.object_or_null({"loops", "of a mechanism that is closed"}, motion.loops, put_loops);
  put_sticking(to, motion.sticking);
  to.list("states", "", motion.states,
          [](Fields& of, const ChainInstant& state) { put_state(of, state); });
  to.list({"hand_formulas", "formulas of the case beside what the program computes"}, "{name}",
          motion.hand_formulas, put_hand_formula);
}

}  // namespace boxbeam::report

namespace boxbeam {

std::string motion_json(const AnyMotionResult& motion) {
  return report::document_text([&](report::Fields fields) { report::put_motion(fields, motion); });
}

std::string assemblies_json(const std::vector<AssemblyResult>& assemblies, double time) {
  using Named = std::pair<std::string, Eigen::Vector3d>;
  return report::document_text([&](report::Fields to) {
    to.constant("schema", "boxbeam.assemblies/1");
    to.constant("kind", "planar");
    to.number("time", "s", time);
    to.list("assemblies", "", assemblies, [](report::Fields& of, const AssemblyResult& assembly) {
      report::put_branch(of, assembly.branch);
      of.named(
          "bodies", assembly.bodies, [](const Named& body) { return body.first; },
          [](report::Fields& at, const Named& body) {
            at.number("x", "m", body.second.x());
            at.number("y", "m", body.second.y());
            at.number("angle", "rad", body.second.z());
          });
    });
  });
}

}  // namespace boxbeam
