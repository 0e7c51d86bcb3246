#pragma once
// The variables of a program's top level, read and set by the host that owns the Vm, while it is
// not running:
//
//     double speed = vm.global<double>("speed");      // in SI units
//     double in_mm = vm.global("speed").in("mm/s");
//     vm.set("speed", 0.2, "m/s");                    // the unit is checked
//
// and the way of their values into a new version of the program.

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

// The variable, which has a value of this kind.
//
// throws  ArgumentError if there is none, or the Vm runs.
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

// What `carry_globals` did, by the names of the new program's variables.
struct CarriedGlobals {
  struct Lost {
    std::string name;
    std::string why;  // "it was a length, and is a time"
  };
  std::vector<std::string> kept;
  std::vector<Lost> lost;          // in both programs, or in the old one only
  std::vector<std::string> fresh;  // in the new one only
};

// Gives the variables of `to` the values that those of `from` have with the same name and type:
// both programs have ended. Variables that cannot change (`let`) stay as the new program says.
//
// throws  ArgumentError if one of them runs, or has not ended.
CarriedGlobals carry_globals(Vm& from, Vm& to);

}  // namespace armlet
