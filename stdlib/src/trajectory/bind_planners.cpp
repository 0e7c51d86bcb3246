// Planners that programs define (language reference, 13.2).

#include <fmt/format.h>

#include <cmath>
#include <vector>

#include "armlet/stdlib/host.hpp"
#include "armlet/trajectory/law_planner.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

constexpr int kPieces = 64;  // of a law given as a function

// Registers the planner under its name for the rest of the run.
void add_planner(Vm& vm, std::string_view name, ScalarLaw law) {
  Host::of(vm).planners().add(std::string(name), planner_of_law(std::move(law)));
}

Answer<void> add_polynomial(Vm& vm, std::string_view name, std::span<const double> law) try {
  for (const double c : law) {
    if (!std::isfinite(c)) return not_finite(vm, "a coefficient of the law", c, at("law"));
  }
  add_planner(vm, name, law_of_polynomial(law));
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error, at("law"));
}

Answer<void> add_function(Vm& vm, std::string_view name,
                          const ScriptFunction<double(double)>& law) try {
  std::vector<double> values;
  for (int k = 0; k <= kPieces; ++k) {
    const auto s = law(static_cast<double>(k) / kPieces);
    if (!s) return Failed{};
    if (!std::isfinite(*s)) return not_finite(vm, "a value of the law", *s, at("law"));
    values.push_back(*s);
  }
  add_planner(vm, name, law_of_values(values));
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0626", error, at("law"));
}

std::vector<std::string> planner_names(Vm& vm) { return Host::of(vm).planners().names(); }

constexpr NativeFunction kPlannersFunctions[] = {
    def<add_polynomial>(
        "addPlanner(name: string, law: double[])",
        "Adds a planner of one's own, or replaces one: all joints go the fraction s(x) of their "
        "way in the fraction x of the time. law holds the coefficients c0, c1, c2 ... of s, which "
        "leads from 0 at x = 0 to 1 at x = 1. Limits on jerk count where the acceleration of the "
        "law is continuous and zero at both ends.",
        "addPlanner(\"Mine\", [0.0, 0.0, 3.0, -2.0]); moveJ(home(), traj: \"Mine\")"),
    def<add_function>(
        "addPlanner(name: string, law: fn(double) -> double)",
        "The same with s as a function. It is called at once for x = 0, 1/64, 2/64 ... 1, and a "
        "cubic spline leads through its values.",
        "addPlanner(\"Wave\", fn(x) => 0.5 - 0.5 * cos(x * 180deg)); moveJ(home(), traj: "
        "\"Wave\")"),
    def<planner_names>("planners() -> string[]",
                       "The names of all planners, those of the program included.", "planners()"),
};

}  // namespace

std::span<const NativeFunction> planner_functions() { return kPlannersFunctions; }

}  // namespace armlet::bind
