#include "programs/fmu/description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "libcontact/version.hpp"

namespace hinge_fmu {
namespace {

using contact_hosts::fmu::Model;
using contact_hosts::fmu::Role;
using contact_hosts::fmu::Variable;

// Units of joints in SI units.
struct Unit {
  const char* name;
  const char* base;
};
constexpr Unit units[] = {
    {"N", R"(kg="1" m="1" s="-2")"},     {"N.m", R"(kg="1" m="2" s="-2")"},
    {"N.m.s", R"(kg="1" m="2" s="-1")"}, {"Pa", R"(kg="1" m="-1" s="-2")"},
    {"1/Pa", R"(kg="-1" m="1" s="2")"},  {"W", R"(kg="1" m="2" s="-3")"},
    {"m3/s", R"(m="3" s="-1")"},         {"rad", R"(rad="1")"},
    {"rad/s", R"(rad="1" s="-1")"},      {"s", R"(s="1")"},
};

std::string units_text(const std::vector<Variable>& all) {
  std::string text = "  <UnitDefinitions>\n";
  for (const Unit& u : units) {
    if (std::ranges::find(all, u.name, &Variable::unit) == all.end()) continue;
    text += fmt::format("    <Unit name=\"{}\"><BaseUnit {}/></Unit>\n", u.name,
                        u.base);
  }
  return text + "  </UnitDefinitions>\n";
}

const char* causality(Role role) {
  switch (role) {
    case Role::parameter:
      return "parameter";
    case Role::input:
      return "input";
    case Role::output:
      return "output";
    case Role::time:
      break;
  }
  return "independent";
}

const char* variability(const Variable& v) {
  if (v.role == Role::parameter) return "fixed";
  return v.is_flag ? "discrete" : "continuous";
}

bool has_start(const Variable& v) {
  return v.role == Role::parameter || v.role == Role::input;
}

// Attributes of the value: unit and start value.
std::string value_text(const Variable& v) {
  std::string text;
  if (!v.unit.empty()) text += fmt::format(" unit=\"{}\"", v.unit);
  if (has_start(v)) {
    text += v.is_flag ? fmt::format(" start=\"{}\"", v.start != 0)
                      : fmt::format(" start=\"{}\"", v.start);
  }
  return text;
}

std::string variable_text(const Variable& v, std::size_t reference,
                          int version) {
  const std::string common = fmt::format(
      R"(name="{}" valueReference="{}" description="{}" causality="{}" )"
      R"(variability="{}")",
      escaped(v.name), reference, escaped(v.meaning), causality(v.role),
      variability(v));
  return version == 2
             ? fmt::format("    <ScalarVariable {}><{}{}/></ScalarVariable>\n",
                           common, v.is_flag ? "Boolean" : "Real",
                           value_text(v))
             : fmt::format("    <{} {}{}/>\n",
                           v.is_flag ? "Boolean" : "Float64", common,
                           value_text(v));
}

// Outputs, which depend on all inputs and parameters.
std::string structure(const Model& model, int version) {
  std::string outputs;
  std::string unknowns;
  const auto& all = model.variables();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].role != Role::output) continue;
    if (version == 2) {
      outputs += fmt::format("      <Unknown index=\"{}\"/>\n", i + 1);
    } else {
      outputs += fmt::format("    <Output valueReference=\"{}\"/>\n", i);
      unknowns +=
          fmt::format("    <InitialUnknown valueReference=\"{}\"/>\n", i);
    }
  }
  return version == 2
             ? fmt::format(
                   "    <Outputs>\n{0}    </Outputs>\n"
                   "    <InitialUnknowns>\n{0}    </InitialUnknowns>\n",
                   outputs)
             : outputs + unknowns;
}

std::string interface(const Description& d, const char* element) {
  const bool is_2 = d.version == 2;
  const char* const state = is_2 ? "FMUstate" : "FMUState";
  const bool steps = std::string_view(element) == "CoSimulation";
  return fmt::format(
      "  <{0} modelIdentifier=\"{1}\" canGetAndSet{2}=\"true\" "
      "canSerialize{2}=\"true\"{3}{4}/>\n",
      element, d.identifier, state,
      is_2 ? " canNotUseMemoryManagementFunctions=\"true\"" : "",
      steps ? " canHandleVariableCommunicationStepSize=\"true\"" : "");
}

}  // namespace

std::string escaped(const std::string& text) {
  static const std::map<char, const char*> names = {
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}};
  std::string result;
  for (const char c : text) {
    if (const auto found = names.find(c); found != names.end()) {
      result += found->second;
    } else if (static_cast<unsigned char>(c) >= ' ') {
      result += c;
    }
  }
  return result;
}

std::string Description::text(const Model& model) const {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
  text += fmt::format(
      "<fmiModelDescription fmiVersion=\"{}.0\" modelName=\"{}\" {}=\"{}\" "
      "generationTool=\"libcontact {}\" variableNamingConvention=\"flat\"{}>\n",
      version, escaped(name), version == 2 ? "guid" : "instantiationToken",
      token, contact::version,
      model_exchange ? " numberOfEventIndicators=\"2\"" : "");
  if (model_exchange) text += interface(*this, "ModelExchange");
  text += interface(*this, "CoSimulation") + units_text(model.variables());
  if (stop_time > 0) {
    text += fmt::format("  <DefaultExperiment stopTime=\"{}\"/>\n", stop_time);
  }
  text += "  <ModelVariables>\n";
  for (std::size_t i = 0; i < model.variables().size(); ++i) {
    text += variable_text(model.variables()[i], i, version);
  }
  return text + "  </ModelVariables>\n  <ModelStructure>\n" +
         structure(model, version) +
         "  </ModelStructure>\n</fmiModelDescription>\n";
}

}  // namespace hinge_fmu
