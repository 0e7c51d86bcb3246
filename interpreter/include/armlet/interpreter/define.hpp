#pragma once
// Functions of C++ as functions of the language, by their own types:
//
//     Answer<double> middle(Vm& vm, std::span<const double> xs, std::optional<double> weight);
//
//     constexpr NativeFunction kFunctions[] = {
//         def<middle>("middle(xs: D[], weight: double?) -> D", "The weighted mean.",
//         "middle([1.0])"),
//     };
//
// The parameters stand in the order of the signature; a Vm& in front of them is not one. Both are
// compared when functions are added to an engine (signature_faults).
//
//   of the signature       of C++
//   double, a quantity     double
//   int, an enum           std::int64_t
//   bool, string           bool, std::string_view
//   double[], time[] ...   std::span<const double>
//   any other list         std::span<const Slot> or const ListObj&; of a type of the host: HostList<T>
//   matrix                 const MatrixObj&
//   a type of the host     const T&, for which kHostType<T> names it
//   a struct, a table      const RecordObj&
//   fn(...) -> ...         ScriptFunction, or FunctionValue to hand it on
//   T and all the others   Slot
//   name: type?            std::optional of the above, const T* for a type of the host
//
// Results are the same, or what owns them: std::string, std::vector<double>, std::vector<T> of a
// type of the host, Obj* (a new reference; null: it failed), std::unique_ptr<Waiting> of what takes
// time. Answer<T> is a result that may be a failure; void and Answer<void> are none.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/script_function.hpp"

namespace armlet {

// The type of the language whose values are T in C++; specialise it beside the HostType.
template <class T>
inline constexpr const HostType* kHostType = nullptr;

template <class T>
concept HostValue = kHostType<std::remove_cvref_t<T>>
!= nullptr;

// A function value that is handed on, borrowed from the argument.
struct FunctionValue {
  Obj* object;
};

// A list of values of a type of the host, borrowed from the argument.
template <HostValue T>
class HostList {
 public:
  explicit HostList(std::span<const Slot> items) : items_(items) {}
  [[nodiscard]] std::size_t size() const { return items_.size(); }
  [[nodiscard]] bool empty() const { return items_.empty(); }
  [[nodiscard]] const T& operator[](std::size_t i) const { return host_value<T>(items_[i]); }

 private:
  std::span<const Slot> items_;
};

// ---- parameters
// ---------------------------------------------------------------------

// How a parameter of type T is read from its slot: `kKind`, and read(vm, slot). Specialise it for a
// type of your own.
template <class T>
struct Argument;

template <>
struct Argument<Slot> {
  static constexpr ValueKind kKind{};
  static Slot read(Vm&, Slot slot) { return slot; }
};
template <>
struct Argument<double> {
  static constexpr ValueKind kKind{ValueKind::Form::kReal};
  static double read(Vm&, Slot slot) { return slot.d; }
};
template <>
struct Argument<std::int64_t> {
  static constexpr ValueKind kKind{ValueKind::Form::kInt};
  static std::int64_t read(Vm&, Slot slot) { return slot.i; }
};
template <>
struct Argument<bool> {
  static constexpr ValueKind kKind{ValueKind::Form::kBool};
  static bool read(Vm&, Slot slot) { return slot.i != 0; }
};
template <>
struct Argument<std::string_view> {
  static constexpr ValueKind kKind{ValueKind::Form::kText};
  static std::string_view read(Vm&, Slot slot) { return text_value(slot); }
};
template <>
struct Argument<std::span<const double>> {
  static constexpr ValueKind kKind{ValueKind::Form::kReals};
  static std::span<const double> read(Vm&, Slot slot) { return reals_value(slot); }
};
template <>
struct Argument<std::span<const Slot>> {
  static constexpr ValueKind kKind{ValueKind::Form::kItems};
  static std::span<const Slot> read(Vm&, Slot slot) { return items_value(slot); }
};
template <>
struct Argument<const ListObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kItems};
  static const ListObj& read(Vm&, Slot slot) { return *static_cast<const ListObj*>(slot.o); }
};
template <>
struct Argument<const MatrixObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kMatrix};
  static const MatrixObj& read(Vm&, Slot slot) { return matrix_value(slot); }
};
template <>
struct Argument<const RecordObj&> {
  static constexpr ValueKind kKind{ValueKind::Form::kRecord};
  static const RecordObj& read(Vm&, Slot slot) { return *static_cast<const RecordObj*>(slot.o); }
};
template <>
struct Argument<FunctionValue> {
  static constexpr ValueKind kKind{ValueKind::Form::kFunction};
  static FunctionValue read(Vm&, Slot slot) { return {slot.o}; }
};
template <class Function>
struct Argument<ScriptFunction<Function>> {
  static constexpr ValueKind kKind{ValueKind::Form::kFunction};
  static ScriptFunction<Function> read(Vm& vm, Slot slot) {
    return ScriptFunction<Function>(vm, slot);
  }
};
template <HostValue T>
struct Argument<const T&> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, kHostType<T>};
  static const T& read(Vm&, Slot slot) { return host_value<T>(slot); }
};
template <HostValue T>
struct Argument<const T*> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, true, kHostType<T>};
  static const T* read(Vm&, Slot slot) {
    return slot.o == nullptr ? nullptr : &host_value<T>(slot);
  }
};
template <HostValue T>
struct Argument<HostList<T>> {
  static constexpr ValueKind kKind{ValueKind::Form::kHosts, false, kHostType<T>};
  static HostList<T> read(Vm&, Slot slot) { return HostList<T>(items_value(slot)); }
};
template <class T>
struct Argument<std::optional<T>> {
  static constexpr ValueKind kKind{Argument<T>::kKind.form, true, Argument<T>::kKind.host};
  static std::optional<T> read(Vm& vm, Slot slot) {
    constexpr ValueKind::Form kForm = Argument<T>::kKind.form;
    constexpr bool kIsScalar = kForm == ValueKind::Form::kReal || kForm == ValueKind::Form::kInt ||
                               kForm == ValueKind::Form::kBool;
    if (kIsScalar ? is_absent_scalar(slot) : slot.o == nullptr) return std::nullopt;
    return Argument<T>::read(vm, slot);
  }
};

// ---- results
// ---------------------------------------------------------------------

// How a result of type T is left in a slot: `kKind`, and leave(vm, value, slot), which may fail.
template <class T>
struct Given;

template <>
struct Given<void> {
  static constexpr ValueKind kKind{ValueKind::Form::kNothing};
};
template <class T>
requires SlotNumber<T>
struct Given<T> {
  static constexpr ValueKind kKind = Argument<T>::kKind;
  static Signal leave(Vm&, T value, Slot& slot) {
    slot = slot_of(value);
    return Signal::kDone;
  }
};
template <class T>
requires std::is_convertible_v<T, Obj*>
struct Given<T> {
  static constexpr ValueKind kKind{};
  static Signal leave(Vm&, Obj* object, Slot& slot) { return give(&slot, object); }
};
template <class T>
requires std::is_convertible_v<const T&, std::string_view>
struct Given<T> {
  static constexpr ValueKind kKind{ValueKind::Form::kText};
  static Signal leave(Vm& vm, std::string_view text, Slot& slot) {
    return give(&slot, new_text(vm, text));
  }
};
template <>
struct Given<std::vector<double>> {
  static constexpr ValueKind kKind{ValueKind::Form::kReals};
  static Signal leave(Vm& vm, std::span<const double> values, Slot& slot) {
    return give(&slot, new_reals(vm, values));
  }
};
template <HostValue T>
struct Given<T> {
  static constexpr ValueKind kKind = Argument<const T&>::kKind;
  static Signal leave(Vm& vm, T value, Slot& slot) {
    return give(&slot, new_host_value(vm, *kHostType<T>, std::move(value)));
  }
};
template <HostValue T>
struct Given<std::vector<T>> {
  static constexpr ValueKind kKind = Argument<HostList<T>>::kKind;
  static Signal leave(Vm& vm, std::vector<T> values, Slot& slot) {
    ListObj* list = new_list(vm, static_cast<std::uint32_t>(values.size()), true);
    for (std::size_t i = 0; list != nullptr && i < values.size(); ++i) {
      list->data[i].o = new_host_value(vm, *kHostType<T>, std::move(values[i]));
      if (list->data[i].o != nullptr) continue;
      release(vm, list);
      list = nullptr;
    }
    return give(&slot, list);
  }
};
// Over at once, or the program goes on when it is.
template <>
struct Given<std::unique_ptr<Waiting>> {
  static constexpr ValueKind kKind{};
  static Signal leave(Vm& vm, std::unique_ptr<Waiting> waiting, Slot& slot) {
    return waiting->is_over() ? waiting->finish(vm, slot) : pause(vm, std::move(waiting));
  }
};
template <class T>
struct Given<Answer<T>> {
  static constexpr ValueKind kKind = Given<T>::kKind;
  static Signal leave(Vm& vm, Answer<T> answer, Slot& slot) {
    if (!answer) return Signal::kFail;
    if constexpr (std::is_void_v<T>) {
      return Signal::kDone;
    } else {
      return Given<T>::leave(vm, *std::move(answer), slot);
    }
  }
};

// ---- functions
// ---------------------------------------------------------------------

namespace typed {

// The parameters and the result of a function, pointer to one, or lambda without template.
template <class F>
struct Shape : Shape<decltype(&F::operator())> {};
template <class R, class... Parameters>
struct Shape<R (*)(Parameters...)> {
  using Result = R;
  using Takes = std::tuple<Parameters...>;
};
template <class R, class... Parameters>
struct Shape<R (*)(Parameters...) noexcept> : Shape<R (*)(Parameters...)> {};
template <class F, class R, class... Parameters>
struct Shape<R (F::*)(Parameters...) const> : Shape<R (*)(Parameters...)> {};

// Calls `function` with the slots as its parameters and leaves its result in the first of them.
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
      function(first..., Argument<Parameters>::read(vm, args[I])...);
      return Signal::kDone;
    } else {
      return Given<Result>::leave(
          vm, function(first..., Argument<Parameters>::read(vm, args[I])...), args[0]);
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

// Where the parameters begin in "name(x: double) -> double"; names may hold "()": "robot()() ->
// ...".
constexpr std::size_t parameters_begin(std::string_view text) {
  const std::size_t open = text.find('(');
  return text.substr(open).starts_with("()(") ? open + 2 : open;
}

// A function that may be a constant: its address is part of the code.
template <auto kFunction>
Signal call_constant(Vm& vm, Slot* args) {
  return SplitOf<decltype(kFunction)>::call(vm, args, kFunction);
}

template <class F>
Signal call_closure(Vm& vm, Slot* args, const void* closure) {
  return SplitOf<F>::call(vm, args, *static_cast<const F*>(closure));
}

}  // namespace typed

// What there is to say of a function beside its types; the members are those of NativeFunction.
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
          .in_path = options.in_path,
          .takes = SplitOf<F>::Calls::takes(),
          .gives = &SplitOf<F>::Calls::kGives};
}

}  // namespace typed

// What CallOptions::explain takes: a function with the same parameters that gives a text.
template <auto kFunction>
inline constexpr Thunk explained_by{&typed::call_constant<kFunction>};

// A function without anything in C++ behind it: its rule refuses every call, or the program itself
// runs it.
constexpr NativeFunction declare(std::string_view signature, std::string_view help,
                                 std::string_view example, void (*check)(CheckCall& call) = nullptr) {
  const std::size_t begin = typed::parameters_begin(signature);
  return {.name = signature.substr(0, begin),
          .signature = signature.substr(begin),
          .help = help,
          .example = example,
          .check = check};
}

// The function `signature`, which begins with its name, as a call of kFunction.
template <auto kFunction>
constexpr NativeFunction def(std::string_view signature, std::string_view help,
                             std::string_view example, const CallOptions& options = {}) {
  return typed::row<decltype(kFunction)>(signature, help, example, options,
                                         Thunk(&typed::call_constant<kFunction>));
}

// A function and what it keeps, for Engine::define.
struct Definition {
  NativeFunction function;
  std::shared_ptr<const void> kept;
};

// The same of a function, a pointer to one, or a lambda with captures.
template <class F>
Definition def(std::string signature, F function, std::string help, std::string example,
               const CallOptions& options = {}) {
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
