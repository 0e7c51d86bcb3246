// Time and signals (language reference, sections 12 and 19).

#include <fmt/format.h>

#include "armlet/stdlib/host.hpp"
#include "bind.hpp"

namespace armlet::bind {
namespace {

Signal now(Vm& vm, Slot* args) { return give(args, to_seconds(vm.timeline().now_ns())); }

Signal get_signal(Vm& vm, Slot* args) {
  const auto value = Host::of(vm).cell().signals().get(text_value(args[0]));
  return give(args, value && std::holds_alternative<bool>(*value) && std::get<bool>(*value));
}
Signal set_signal(Vm& vm, Slot* args) {
  Host::of(vm).cell().signals().set(text_value(args[0]), args[1].i != 0);
  return give_nothing();
}
Signal get_number(Vm& vm, Slot* args) {
  const auto value = Host::of(vm).cell().signals().get(text_value(args[0]));
  return give(args,
              value && std::holds_alternative<double>(*value) ? std::get<double>(*value) : 0.0);
}
Signal set_number(Vm& vm, Slot* args) {
  Host::of(vm).cell().signals().set(text_value(args[0]), args[1].d);
  return give_nothing();
}

constexpr NativeFunction kTimeFunctions[] = {
    {"now", "() -> time", "The virtual time.", "now()", now},
    {"signal", "(name: string) -> bool", "Whether a signal is on; one that was never set is off.",
     "signal(\"start\")", get_signal},
    {"setSignal", "(name: string, on: bool)", "Switches a signal.", "setSignal(\"lamp\", true)",
     set_signal},
    {"number", "(name: string) -> double",
     "The value of a numeric signal; one that was never set is 0.", "number(\"level\")",
     get_number},
    {"setNumber", "(name: string, x: double)", "Sets a numeric signal.",
     "setNumber(\"level\", 2.5)", set_number},
};

}  // namespace

std::span<const NativeFunction> time_functions() { return kTimeFunctions; }

}  // namespace armlet::bind
