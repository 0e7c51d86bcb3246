#pragma once
// Functions of a program as functions of C++, called by the host that owns the Vm:
//
//     const auto on_tick = vm.function<double(double)>("on_tick");
//     if (const Answer<double> power = on_tick(0.001)) use(*power);
//     else std::cerr << vm.error_text();
//
// Parameters and results are double (of a quantity: in SI units), std::int64_t (also an enum),
// bool, std::string, std::vector<double>, Value, and types of the host; a result may be void. A
// function may be called whenever the Vm is not running: when the program has ended, and between
// two slices of its run. It may not take virtual time. It belongs to its Vm, and may be copied.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "armlet/interpreter/answer.hpp"
#include "armlet/interpreter/binding/stored.hpp"
#include "armlet/interpreter/binding/typed_results.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/host/vm.hpp"

namespace armlet {

// The common part of all calls of one function, whose types have been compared.
class ReadyFunction {
 public:
  static constexpr std::size_t kMostParameters = 16;

  struct Outcome {
    bool done;            // false: the call failed, and Vm::error has the reason
    double result = 0.0;  // set if the result is a double; faster than the slot
  };

  // takes, gives  the C++ types of the parameters and the result.
  // returns       an error that shows both signatures if there is no such function.
  static Result<ReadyFunction> find(Vm& vm, std::string_view name, std::span<const ValueKind> takes,
                                    const ValueKind& gives);

  // Calls the function and stores its result, a number, in `result`.
  //
  // throws  ArgumentError while the Vm is running, in another thread or in the host function that
  //         makes this call; and if the entry of a session that declares the function has failed.
  Outcome run(std::span<const Slot> arguments, Slot& result) const;
  // Calls the function with at most three arguments, which are passed in registers; arguments
  // beyond the parameters are ignored.
  Outcome run(Slot first, Slot second, Slot third, Slot& result) const;
  // Calls a function of at most three doubles that returns a double.
  Outcome run_reals() const;
  Outcome run_reals(double only) const;
  Outcome run_reals(double first, double second, double third = 0.0) const;

  // Whether the steps of a call are counted apart from the run, or with it. In the second case a
  // replay of the run has to repeat the call, and a log of the run contains it
  // (stdlib/session_log.hpp).
  enum class Counts : std::uint8_t { kApart, kWithRun };

  // A call whose arguments or result are objects. During its lifetime no other call of the Vm is
  // possible.
  class Call {
   public:
    explicit Call(const ReadyFunction& function, Counts counts = Counts::kApart);
    ~Call();
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    template <class T>
    [[nodiscard]] bool pass(std::size_t parameter, const T& value, Slot& slot);
    [[nodiscard]] Outcome run(std::span<const Slot> arguments, Slot& result);
    template <class T>
    [[nodiscard]] T take(Slot result);

   private:
    void pass_value(std::size_t parameter, const Value& value, Slot& slot);
    void require_text(std::size_t parameter, std::string_view text) const;
    [[nodiscard]] Value take_value(Slot result);
    void keep(Obj* object);
    void fail();

    const ReadyFunction& function_;
    Counts counts_;
    std::array<Obj*, kMostParameters + 1> kept_{};
    std::size_t count_ = 0;
  };

  // Lets the function run like a program: in slices, with Vm::run, and it may take virtual time.
  // The program must have ended. If the function fails, its changes stay; its result is dropped.
  //
  // throws  ArgumentError unless the program has run to its end and all its variables have values;
  //         if the count or a type of the arguments is wrong; and as run.
  void begin(std::span<const Value> arguments) const;

  // throws  ArgumentError with the parameter for which NaN was passed.
  [[noreturn, gnu::cold]] void refuse_undefined(std::size_t parameter) const;

  [[nodiscard]] Vm& vm() const { return *vm_; }

 private:
  ReadyFunction(Vm& vm, std::uint32_t function);

  Vm* vm_;
  Vm::State* state_;        // of the Vm
  std::uint32_t function_;  // its number in the program
};

namespace typed {

template <class T>
constexpr ValueKind passed_kind() {
  if constexpr (std::is_void_v<T>) {
    return {ValueKind::Form::kNothing};
  } else if constexpr (std::is_same_v<T, Value>) {
    return {};
  } else {
    return kStoredKind<T>;
  }
}

// Whether a value is NaN, or a list with a NaN.
template <class T>
[[nodiscard]] bool is_undefined(const T& value) {
  if constexpr (std::is_same_v<T, double>) {
    return value != value;
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    for (const double each : value)
      if (each != each) return true;
    return false;
  } else {
    return false;
  }
}

// The index of the first value that is or contains a NaN.
template <class... T>
[[nodiscard, gnu::cold]] std::size_t first_undefined(const T&... values) {
  std::size_t at = 0;
  static_cast<void>(((is_undefined(values) || (++at, false)) || ...));
  return at;
}

// The C++ type without const and references; const std::string& and std::string_view become
// std::string.
template <class T>
using Passed = std::conditional_t<std::is_same_v<std::remove_cvref_t<T>, std::string_view> ||
                                      std::is_same_v<std::decay_t<T>, const char*>,
                                  std::string, std::remove_cvref_t<T>>;

}  // namespace typed

template <class Signature>
class ProgramFunction;

template <class Result_, class... Arguments>
class ProgramFunction<Result_(Arguments...)> {
  static_assert(sizeof...(Arguments) <= ReadyFunction::kMostParameters);

 public:
  static Result<ProgramFunction> find(Vm& vm, std::string_view name) {
    static constexpr std::array<ValueKind, sizeof...(Arguments)> kTakes{
        typed::passed_kind<typed::Passed<Arguments>>()...};
    static constexpr ValueKind kGives = typed::passed_kind<Result_>();
    Result<ReadyFunction> ready = ReadyFunction::find(vm, name, kTakes, kGives);
    if (!ready) return ready.error();
    return ProgramFunction(*ready);
  }

  // throws  ArgumentError for NaN, and while the Vm is running (ReadyFunction::run).
  Answer<Result_> operator()(const typed::Passed<Arguments>&... arguments) const {
    if ((typed::is_undefined(arguments) || ...)) [[unlikely]]
      ready_.refuse_undefined(typed::first_undefined(arguments...));
    if constexpr (kIsReal) {
      const ReadyFunction::Outcome outcome = ready_.run_reals(arguments...);
      if (!outcome.done) return Failed{};
      return outcome.result;
    } else if constexpr (kIsPlain) {
      Slot result{.i = 0};
      if (!run(result, slot_of(arguments)...).done) return Failed{};
      if constexpr (std::is_void_v<Result_>) {
        return {};
      } else {
        return number_in<Result_>(result);
      }
    } else {
      return call(std::index_sequence_for<Arguments...>{}, arguments...);
    }
  }

 private:
  // Numbers need no memory of the heap.
  template <class T>
  static constexpr bool kIsNumber = SlotNumber<T> || std::is_void_v<T>;
  static constexpr bool kIsPlain =
      kIsNumber<Result_> && (kIsNumber<typed::Passed<Arguments>> && ...);
  // Doubles are passed in registers.
  static constexpr bool kIsReal = std::is_same_v<Result_, double> && sizeof...(Arguments) <= 3 &&
                                  (std::is_same_v<typed::Passed<Arguments>, double> && ...);

  explicit ProgramFunction(const ReadyFunction& ready) : ready_(ready) {}

  ReadyFunction::Outcome run(Slot& result, Slot first = {.i = 0}, Slot second = {.i = 0},
                             Slot third = {.i = 0}) const {
    return ready_.run(first, second, third, result);
  }
  template <class... More>
  requires(sizeof...(More) > 3) ReadyFunction::Outcome run(Slot& result, More... slots)
  const { return ready_.run(std::array<Slot, sizeof...(More)>{slots...}, result); }

  template <std::size_t... I>
  Answer<Result_> call(std::index_sequence<I...>,
                       const typed::Passed<Arguments>&... arguments) const;

  ReadyFunction ready_;
};

template <class Result_, class... Arguments>
template <std::size_t... I>
Answer<Result_> ProgramFunction<Result_(Arguments...)>::call(
    std::index_sequence<I...>, const typed::Passed<Arguments>&... arguments) const {
  ReadyFunction::Call call(ready_);
  std::array<Slot, sizeof...(Arguments)> slots{};
  Slot result{.i = 0};
  if (!(call.pass(I, arguments, slots[I]) && ...)) return Failed{};
  if (!call.run(slots, result).done) return Failed{};
  if constexpr (std::is_void_v<Result_>) {
    return {};
  } else {
    return call.template take<Result_>(result);
  }
}

template <class T>
bool ReadyFunction::Call::pass(std::size_t parameter, const T& value, Slot& slot) {
  if constexpr (SlotNumber<T>) {
    slot = slot_of(value);
    return true;
  } else if constexpr (std::is_same_v<T, Value>) {
    pass_value(parameter, value, slot);
    return true;
  } else {
    if constexpr (std::is_same_v<T, std::string>) require_text(parameter, value);
    if (Given<T>::leave(function_.vm(), value, slot) != Signal::kDone) {
      fail();
      return false;
    }
    keep(slot.o);
    return true;
  }
}

template <class T>
T ReadyFunction::Call::take(Slot result) {
  if constexpr (std::is_same_v<T, Value>) {
    return take_value(result);
  } else {
    if constexpr (!SlotNumber<T>) keep(result.o);
    return typed::stored_in<T>(function_.vm(), result);
  }
}

template <class Signature>
Result<ProgramFunction<Signature>> Vm::try_function(std::string_view name) {
  return ProgramFunction<Signature>::find(*this, name);
}
template <class Signature>
ProgramFunction<Signature> Vm::function(std::string_view name) {
  return try_function<Signature>(name).value();
}

}  // namespace armlet
