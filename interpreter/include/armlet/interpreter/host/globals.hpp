#pragma once
// The global variables of a program, which the host that owns the Vm reads and sets while it is not
// running:
//
//     double speed = vm.global<double>("speed");      // in SI units
//     double in_mm = vm.global("speed").in("mm/s");
//     vm.set("speed", 0.2, "m/s");                    // the unit is checked
//
// The values of an old version of a program can be copied to a new one.

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "armlet/interpreter/binding/stored.hpp"
#include "armlet/interpreter/binding/typed_results.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

namespace typed {

// The slot of a variable with a value of this kind.
//
// throws  ArgumentError if there is none, or the Vm is running.
Slot slot_of_global(Vm& vm, std::string_view name, const ValueKind& kind);

}  // namespace typed

template <class T>
T Vm::global(std::string_view name) {
  return typed::stored_in<T>(*this, typed::slot_of_global(*this, name, typed::kStoredKind<T>));
}

template <class T>
requires(!std::convertible_to<const T&, Value>) void Vm::set(std::string_view name,
                                                             const T& value) {
  set(name, Value(Value::Host{typed::carried_type<T>(), std::make_shared<const T>(value)}));
}

// The result of `carry_globals`, by the names of the new program's variables.
struct CarriedGlobals {
  struct Lost {
    std::string name;
    std::string why;  // "it was a length, and is a time"
  };
  std::vector<std::string> kept;
  std::vector<Lost> lost;          // in both programs, or only in the old one
  std::vector<std::string> fresh;  // only in the new one
};

// Copies the values of variables of `from` to those of `to` with the same name and type; both
// programs must have ended. Constant variables (`let`) keep the values of the new program.
//
// throws  ArgumentError if one of the programs is running, or has not ended.
CarriedGlobals carry_globals(Vm& from, Vm& to);

}  // namespace armlet
