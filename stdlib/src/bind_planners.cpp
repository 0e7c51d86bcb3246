// Planners that programs bring themselves (language reference, 13.2).

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "armlet/interpreter/script_function.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/law_planner.hpp"
#include "bind.hpp"
#include "trajectories.hpp"

namespace armlet::bind {
namespace {

enum Parameter { kPlannerName, kLaw };

constexpr int kPieces = 64;  // of a law given as a function

// Makes the planner known under its name for the rest of the run.
Signal add_planner(Vm& vm, std::string_view name, ScalarLaw law) {
  Host::of(vm).planners().add(std::string(name), planner_of_law(std::move(law)));
  return give_nothing();
}

// (name, coefficients)
Signal add_polynomial(Vm& vm, Slot* args) try {
  const auto coefficients = reals_value(args[kLaw]);
  for (const double c : coefficients) {
    if (!std::isfinite(c)) return not_finite(vm, "a coefficient of the law", c, kLaw);
  }
  return add_planner(vm, text_value(args[kPlannerName]), law_of_polynomial(coefficients));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error, kLaw);
}

// (name, law)
Signal add_function(Vm& vm, Slot* args) try {
  std::vector<double> values;
  const ScriptFunction<double(double)> law(vm, args[kLaw]);
  for (int k = 0; k <= kPieces; ++k) {
    double s = 0.0;
    if (!law.call(s, static_cast<double>(k) / kPieces)) return Signal::kFail;
    if (!std::isfinite(s)) return not_finite(vm, "a value of the law", s, kLaw);
    values.push_back(s);
  }
  return add_planner(vm, text_value(args[kPlannerName]), law_of_values(values));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error, kLaw);
}

Answer<Obj*> planner_names(Vm& vm) {
  const std::vector<std::string> names = Host::of(vm).planners().names();
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(names.size()), true);
  if (list == nullptr) return Failed{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    list->data[i].o = new_text(vm, names[i]);
    if (list->data[i].o != nullptr) continue;
    release(vm, list);
    return Failed{};
  }
  return list;
}

constexpr NativeFunction kPlannersFunctions[] = {
    {"addPlanner", "(name: string, law: double[])",
     "Adds a planner of one's own, or replaces one: all joints go the fraction s(x) of their way "
     "in the fraction x of the time. law holds the coefficients c0, c1, c2 ... of s, which leads "
     "from 0 at x = 0 to 1 at x = 1.",
     "addPlanner(\"Mine\", [0.0, 0.0, 3.0, -2.0]); moveJ(home(), traj: \"Mine\")", add_polynomial},
    {"addPlanner", "(name: string, law: fn(double) -> double)",
     "The same with s as a function. It is called at once for x = 0, 1/64, 2/64 ... 1, and a cubic "
     "spline leads through its values.",
     "addPlanner(\"Wave\", fn(x) => 0.5 - 0.5 * cos(x * 180deg)); moveJ(home(), traj: \"Wave\")",
     add_function},
    def<planner_names>("planners() -> string[]",
                       "The names of all planners, those of the program included.", "planners()"),
};

}  // namespace

std::span<const NativeFunction> planner_functions() { return kPlannersFunctions; }

}  // namespace armlet::bind
