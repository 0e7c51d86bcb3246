// Time and signals (language reference, sections 12 and 19).

#include <fmt/format.h>

#include "armlet/stdlib/host.hpp"
#include "values/bind.hpp"

namespace armlet::bind {
namespace {

double now(Vm& vm) { return to_seconds(vm.timeline().now_ns()); }

template <class T>
T signal_or(Vm& vm, std::string_view name, T otherwise) {
  const auto value = Host::of(vm).cell().signals().get(name);
  return value && std::holds_alternative<T>(*value) ? std::get<T>(*value) : otherwise;
}
bool get_signal(Vm& vm, std::string_view name) { return signal_or(vm, name, false); }
double get_number(Vm& vm, std::string_view name) { return signal_or(vm, name, 0.0); }

template <class T>
void set_signal(Vm& vm, std::string_view name, T value) {
  Host::of(vm).cell().signals().set(name, value);
}

constexpr NativeFunction kTimeFunctions[] = {
    def<now>("now() -> time", "The virtual time.", "now()"),
    def<get_signal>("signal(name: string) -> bool",
                    "Whether a signal is on; one that was never set is off.", "signal(\"start\")"),
    def<set_signal<bool>>("setSignal(name: string, on: bool)", "Switches a signal.",
                          "setSignal(\"lamp\", true)"),
    def<get_number>("number(name: string) -> double",
                    "The value of a numeric signal; one that was never set is 0.",
                    "number(\"level\")"),
    def<set_signal<double>>("setNumber(name: string, x: double)", "Sets a numeric signal.",
                            "setNumber(\"level\", 2.5)"),
};

}  // namespace

std::span<const NativeFunction> time_functions() { return kTimeFunctions; }

}  // namespace armlet::bind
