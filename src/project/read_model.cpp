#include <fmt/format.h>

#include <numbers>

#include "readers.hpp"

namespace boxbeam::readers {

double read_retardation(TableReader& table, std::optional<double> fallback) {
  if (!table.is_table("damping"))
    return table.not_negative({"damping", "of the material: retardation time, or { ratio, at }"},
                              wanted::time, fallback);
  TableReader damping =
      table.table({"damping", "of the material, by its ratio at a frequency"}, !fallback);
  const double ratio = damping.any_number({"ratio", "of the critical damping"});
  const double at = damping.positive({"at", "at this frequency"}, wanted::frequency);
  damping.finish();
  if (ratio < 0.0 || ratio >= 1.0) {
    damping.problem("ratio", "a damping ratio is from 0 to below 1",
                    "write for example ratio = 0.01, which is 1 % of the critical damping");
  }
  return ratio / (std::numbers::pi * at);
}

ElasticForm read_model(TableReader& root, Project& project) {
  ElasticForm form;
  ModelInput& input = project.model;
  if (!root.has("model")) return form;
  TableReader table = root.table({"model", "which model of the beam in its mechanism"});
  const auto read_moduli = [&] {
    input.youngs_modulus =
        table.positive({"youngs_modulus", "of the beam"}, wanted::stress, input.youngs_modulus);
    input.shear_modulus =
        table.positive({"shear_modulus", "of the beam"}, wanted::stress, input.shear_modulus);
  };
  const auto read_tolerance = [&] {
    input.tolerance = table.number(
        {"tolerance", "largest error of the governing stress that is accepted"}, input.tolerance);
    if (input.tolerance >= 1.0) {
      table.problem("tolerance", "the tolerance is a fraction of the governing stress, below 1",
                    "write tolerance = 0.01 for 1 %");
    }
  };
  const bool frame = std::holds_alternative<frame::Structure>(project.mechanism);
  if (frame || std::holds_alternative<recorded::Loads>(project.mechanism)) {
    read_moduli();
    // How a frame vibrates under loads over time.
    if (frame) {
      read_tolerance();
      input.retardation = read_retardation(table, input.retardation);
    }
    table.finish();
    return form;
  }
  constexpr ModelDemand demands[] = {ModelDemand::automatic, ModelDemand::rigid,
                                     ModelDemand::flexible};
  input.demand = demands[table.choice({"demand", "which model is enough, and of what"},
                                      {"auto", "rigid", "flexible"}, 0)];
  read_tolerance();
  read_moduli();
  input.retardation = read_retardation(table, input.retardation);
  if (std::holds_alternative<flexible::Mechanism>(project.mechanism)) {
    constexpr flexible::Element elements[] = {
        flexible::Element::corrected, flexible::Element::classical, flexible::Element::exact};
    form.element = elements[table.choice(
        {"element", "how rigid elements bend; \"exact\": the continuous links, without division"},
        {"corrected", "classical", "exact"}, 0)];
    form.nodes_at_joints = table.choice({"division", "nodes stand at joints, or equal parts"},
                                        {"nodes at joints", "equal"}, 0) == 0;
    if (form.element == flexible::Element::exact && !form.nodes_at_joints) {
      table.problem("division", "the exact form of the links has its nodes at joints",
                    "leave out division, or write element = \"corrected\"");
    }
  }
  if (std::holds_alternative<planar::Mechanism>(project.mechanism)) {
    input.measured_loads =
        table.choice(
            {"loads",
             "measured on the running machine, they contain its vibration: bodies stay rigid"},
            {"computed", "measured"}, 0) == 1;
    if (input.measured_loads && input.demand == ModelDemand::flexible) {
      table.problem("demand",
                    "measured loads contain the vibration of the machine, which an elastic model "
                    "would count twice",
                    "write demand = \"rigid\" or leave it out");
    }
  }
  table.finish();
  return form;
}

}  // namespace boxbeam::readers
