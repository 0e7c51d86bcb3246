#pragma once
// Makes functions of the language from C++ functions, by their C++ types:
//
//     Answer<double> middle(Vm& vm, std::span<const double> xs, std::optional<double> weight);
//
//     constexpr NativeFunction kFunctions[] = {
//         def<middle>("middle(xs: D[], weight: double?) -> D", "The weighted mean.",
//         "middle([1.0])"),
//     };
//
// A member function of a host type is a function of that type: def<&Pear::weight>(...). The
// parameters have the order of the signature; a Vm& before them is not counted.
// typed_parameters.hpp lists the types of parameters, typed_results.hpp those of results. Both are
// compared with the signature: Engine::define throws if they differ, Engine::check_signatures
// reports differences in tables.

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "armlet/core/error.hpp"
#include "armlet/interpreter/binding/typed_parameters.hpp"
#include "armlet/interpreter/binding/typed_results.hpp"

namespace armlet {

namespace typed {

// The parameters and the result of a function, of a member function of a host type, and of a lambda
// that is not a template.
template <class Call>
struct OfLambda;
template <class F, class R, class... Parameters>
struct OfLambda<R (F::*)(Parameters...) const> {
  using Result = R;
  using Takes = std::tuple<Parameters...>;
};
template <class F>
struct Shape : OfLambda<decltype(&F::operator())> {};
template <class R, class... Parameters>
struct Shape<R (*)(Parameters...)> {
  using Result = R;
  using Takes = std::tuple<Parameters...>;
};
template <class R, class... Parameters>
struct Shape<R (*)(Parameters...) noexcept> : Shape<R (*)(Parameters...)> {};
template <class T, class R, class... Parameters>
struct Shape<R (T::*)(Parameters...) const> : Shape<R (*)(const T&, Parameters...)> {};
template <class T, class R, class... Parameters>
struct Shape<R (T::*)(Parameters...) const noexcept> : Shape<R (*)(const T&, Parameters...)> {};
template <class T, class V>
requires(!std::is_function_v<V>) struct Shape<V T::*> : Shape<V (*)(const T&)> {
};

// Calls `function` with the slots as its parameters and stores its result in the first of them.
template <class Result, class... Parameters>
struct Caller {
  static constexpr ValueKind kTakes[sizeof...(Parameters) + 1] = {Argument<Parameters>::kKind...};
  static constexpr std::span<const ValueKind> takes() { return {kTakes, sizeof...(Parameters)}; }
  static constexpr ValueKind kGives = Given<Result>::kKind;

  template <class F, class... First>
  static Signal call(Vm& vm, Slot* args, const F& function, First&... first) {
    return read_and_call(vm, args, function, std::index_sequence_for<Parameters...>{}, first...);
  }

 private:
  template <class F, std::size_t... I, class... First>
  static Signal read_and_call(Vm& vm, Slot* args, const F& function, std::index_sequence<I...>,
                              First&... first) {
    if constexpr (std::is_void_v<Result>) {
      std::invoke(function, first..., Argument<Parameters>::read(vm, args[I])...);
      return Signal::kDone;
    } else {
      return Given<Result>::leave(
          vm, std::invoke(function, first..., Argument<Parameters>::read(vm, args[I])...), args[0]);
    }
  }
};

template <class Result, class Takes>
struct Split;
template <class Result, class... Parameters>
struct Split<Result, std::tuple<Parameters...>> {
  using Calls = Caller<Result, Parameters...>;
  template <class F>
  static Signal call(Vm& vm, Slot* args, const F& function) {
    return Calls::call(vm, args, function);
  }
};
template <class Result, class... Parameters>
struct Split<Result, std::tuple<Vm&, Parameters...>> {
  using Calls = Caller<Result, Parameters...>;
  template <class F>
  static Signal call(Vm& vm, Slot* args, const F& function) {
    return Calls::call(vm, args, function, vm);
  }
};
template <class F>
using SplitOf = Split<typename Shape<F>::Result, typename Shape<F>::Takes>;

// The position of the parameters in "name(x: double) -> double". Names may contain "()": "motor()()
// -> ...".
constexpr std::size_t parameters_begin(std::string_view text) {
  const std::size_t open = std::min(text.find('('), text.size());
  return text.substr(open).starts_with("()(") ? open + 2 : open;
}

// The code of a function whose address is a compile-time constant.
template <auto kFunction>
Signal call_constant(Vm& vm, Slot* args) {
  return SplitOf<decltype(kFunction)>::call(vm, args, kFunction);
}

template <class F>
Signal call_closure(Vm& vm, Slot* args, const void* closure) {
  return SplitOf<F>::call(vm, args, *static_cast<const F*>(closure));
}

// The functions of a row with unions.
template <auto... kFunctions>
inline constexpr Alternative kChoices[] = {
    Alternative{.thunk = Thunk(&call_constant<kFunctions>),
                .takes = SplitOf<decltype(kFunctions)>::Calls::takes(),
                .gives = &SplitOf<decltype(kFunctions)>::Calls::kGives}...};

}  // namespace typed

// The properties of a function apart from its types; the members are those of NativeFunction.
struct CallOptions {
  void (*check)(CheckCall& call) = nullptr;
  Thunk explain{};
  double (*real1)(double) = nullptr;
  double (*real2)(double, double) = nullptr;
  double (*real3)(double, double, double) = nullptr;
  bool pauses = false;
  bool commands = false;
  bool interrupts = false;
  bool acts = false;
  bool in_path = false;
  bool starts = false;
  BlockEvent event = BlockEvent::kNone;
  const NativeFunction* timed = nullptr;
};

namespace typed {

template <class F>
constexpr NativeFunction row(std::string_view signature, std::string_view help,
                             std::string_view example, const CallOptions& options, Thunk thunk) {
  const std::size_t begin = parameters_begin(signature);
  return {.name = signature.substr(0, begin),
          .signature = signature.substr(begin),
          .help = help,
          .example = example,
          .thunk = thunk,
          .real1 = options.real1,
          .real2 = options.real2,
          .check = options.check,
          .explain = options.explain,
          .pauses = options.pauses,
          .commands = options.commands,
          .interrupts = options.interrupts,
          .real3 = options.real3,
          .acts = options.acts,
          .starts = options.starts,
          .in_path = options.in_path,
          .event = options.event,
          .timed = options.timed,
          .takes = SplitOf<F>::Calls::takes(),
          .gives = &SplitOf<F>::Calls::kGives};
}

}  // namespace typed

// The value for CallOptions::explain: a function with the same parameters that returns a text.
template <auto kFunction>
inline constexpr Thunk explained_by{&typed::call_constant<kFunction>};

// A function without C++ code: its rule refuses every call, or the compiler makes a loop of the
// call.
constexpr NativeFunction declare(std::string_view signature, std::string_view help,
                                 std::string_view example,
                                 void (*check)(CheckCall& call) = nullptr) {
  const std::size_t begin = typed::parameters_begin(signature);
  return {.name = signature.substr(0, begin),
          .signature = signature.substr(begin),
          .help = help,
          .example = example,
          .check = check};
}

// The function with `signature`, which begins with its name, that calls kFunction. In a signature
// with unions, "to: point | double[]", each choice of types has its own function, or all the same.
template <auto kFunction, auto... kFurther>
constexpr NativeFunction def(std::string_view signature, std::string_view help,
                             std::string_view example, const CallOptions& options = {}) {
  NativeFunction out = typed::row<decltype(kFunction)>(signature, help, example, options,
                                                       Thunk(&typed::call_constant<kFunction>));
  if constexpr (sizeof...(kFurther) > 0) out.alternatives = typed::kChoices<kFunction, kFurther...>;
  return out;
}

// A function with the data that it keeps, for Engine::define.
struct Definition {
  NativeFunction function;
  std::shared_ptr<const void> kept;
};

// The definition for a function, a function pointer, or a lambda with captures.
//
// throws  ArgumentError if the pointer is null.
template <class F>
Definition def(std::string signature, F function, std::string help, std::string example,
               const CallOptions& options = {}) {
  if constexpr (std::is_pointer_v<F> || std::is_member_pointer_v<F>) {
    if (function == nullptr) refuse_argument("There is no function behind `" + signature + "`.");
  }
  struct Kept {
    std::string signature, help, example;
    F function;
  };
  auto kept = std::make_shared<const Kept>(
      Kept{std::move(signature), std::move(help), std::move(example), std::move(function)});
  return {typed::row<F>(kept->signature, kept->help, kept->example, options,
                        Thunk(&typed::call_closure<F>, &kept->function)),
          kept};
}

}  // namespace armlet
