#pragma once
// How a host adds functions, values and rules to the language.
//
// A function is declared by its signature in the notation of the language reference, section 19:
//     {"run", "(m: motor, to: point, time: time?, speed: speed?) -> Run", help, example, &run}
//
//   name: type            required;  name: type = literal  default;  name: type?  optional
//   values: number...     any number of trailing numbers, passed as one double[]
//   D, E                  any quantity or double; D^2, D*E, D/E; D[], (D*E)[] lists of it
//   table; unit(x)        any table; a text, if absent the unit of x, units(x) of its numbers
//   T, U                  any type; fn(T) -> U; as a result Pair{first: T, second: U}
//   to: point | double[]  a union: the row stands for two functions, each with its own C++ code
//                         (`def<&run_to, &run_along>`) or with the same (`def<&run_to>`)
//
// Names with a meaning of their own:
//   "point.x", "point[]"  the field x of a point; indexing: "point.sharp[]" of the kind sharp,
//                         "point[:]" a part. "point.x=" and "point[]=" give the value that
//                         `p.x = v` and `p[i] = v` store, made from the old one.
//   "operator*"           and similar names: operators between host types or lists
//   "motor{}"             is called by a block declaration of type motor. Its parameter `name` gets
//                         the declared name, a parameter `phase: phaseRow[]` the rows
//                         `phase wound(...)`, each made by "motor.phase.wound".
//   "motor.phase.NAME"    makes rows that the program names, `phase u(...)`: it gets the name as
//                         `name`; its `value`, or else its function, is the variable `m.u` that the
//                         host may set. "motor{}" gets all of them in order as `rows`.
//   "motor()", "Math.sqrt"  the ambient motor of the host; a function in a namespace
//   "with.speed"          applies the setting of `with (speed: x)`, "path.blend" one of `path`;
//                         functions with a BlockEvent run where such a block begins and ends.

#include <cstdint>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "armlet/interpreter/binding/thunk.hpp"
#include "armlet/interpreter/binding/waiting.hpp"
#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/failure.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet {

class CheckCall;
struct WorldNames;

// The C++ function for one choice of the types of a row with unions.
struct Alternative {
  Thunk thunk{};
  std::span<const ValueKind> takes{};
  const ValueKind* gives = nullptr;
};

struct NativeFunction {
  std::string_view name;
  std::string_view signature;
  std::string_view help;     // one or two sentences
  std::string_view example;  // one line that runs
  Thunk thunk{};             // null for map, filter ..., which are compiled to loops
  // The function for direct calls, if its result depends only on its arguments: repeated calls may
  // be removed. If it returns no number the thunk is called, which may fail.
  double (*real1)(double) = nullptr;
  double (*real2)(double, double) = nullptr;
  void (*check)(CheckCall& call) = nullptr;  // a rule, which checks calls before the program runs
  // Same arguments -> text: the reason why the result was false (for assert). Further lines of the
  // text replace arguments that are not literals, in their order. For a function with another
  // result: an explanation of the result or of its absence, for explain(f(x)).
  Thunk explain{};
  bool pauses = false;  // takes virtual time: not allowed in conditions
  // Commands its first argument, a resource, as functions that pause do: no other task may then.
  bool commands = false;
  // Pauses, but for a resource that another task commands, as a stop does.
  bool interrupts = false;
  double (*real3)(double, double, double) = nullptr;  // as real1 and real2
  bool acts = false;                                  // has a result, and changes the world
  bool starts = false;  // its function arguments run as tasks, which may take time
  // Allowed in a `path`, which otherwise contains no functions that act or take time: a motion that
  // the path collects, or a setting of its moves.
  bool in_path = false;
  BlockEvent event = BlockEvent::kNone;  // it runs at this event, and no program can call it
  // The function, which pauses, for calls that take time by its rule (CheckCall::take_time).
  const NativeFunction* timed = nullptr;
  // For functions made by `def`: the parameters in the order of the signature, and the result.
  std::span<const ValueKind> takes{};
  const ValueKind* gives = nullptr;  // null: it was not made by `def`
  // For a row with unions: one for each choice of types, the types of the last union vary first;
  // empty if the same C++ function is for all of them.
  std::span<const Alternative> alternatives{};
  const NativeFunction* row = nullptr;  // the row with unions that this function is a choice of
};

// The row of a table that the function was declared by.
[[nodiscard]] inline const NativeFunction& row_of(const NativeFunction& function) {
  return function.row != nullptr ? *function.row : function;
}

// A named number of the library: PI, E.
struct NativeConstant {
  std::string_view name;
  double value = 0.0;  // SI
  Dim dim;
  std::string_view help;
};

// ---- reading arguments and leaving results

template <class T>
[[nodiscard]] const T& host_value(Slot s) {
  return *static_cast<const T*>(static_cast<const HostObj*>(s.o)->payload());
}
[[nodiscard]] inline std::string_view text_value(Slot s) {
  return static_cast<const TextObj*>(s.o)->view();
}
[[nodiscard]] inline std::span<const double> reals_value(Slot s) {
  return static_cast<const ListObj*>(s.o)->reals();
}
[[nodiscard]] inline const MatrixObj& matrix_value(Slot s) {
  return *static_cast<const MatrixObj*>(s.o);
}
[[nodiscard]] inline std::span<const Slot> items_value(Slot s) {
  const auto* list = static_cast<const ListObj*>(s.o);
  return {list->data, list->size};
}
// The rows of a table in the order of time. Each is a record of the row type of the table's type:
// the time, then one field per column.
[[nodiscard]] inline std::span<const Slot> table_rows(Slot table) {
  const auto* record = static_cast<const RecordObj*>(table.o);
  return items_value(record->fields()[record->layout->type->record->fields.size()]);
}
// New objects count for the limit of the heap; null, with the failure set, if they would exceed it.
[[nodiscard]] Obj* new_text(Vm& vm, std::string_view text);
// The count of characters of a text. The first call for a text counts as work. Returns false, with
// the failure set, if the program has to stop.
[[nodiscard]] bool text_length(Vm& vm, Slot text, std::int64_t& characters);
// The characters of a text from `first` to before `last`, which must exist; the time does not
// depend on their position. Null, with the failure set, if that fails.
[[nodiscard]] Obj* new_text_part(Vm& vm, Slot text, std::int64_t first, std::int64_t last);
[[nodiscard]] ListObj* new_list(Vm& vm, std::uint32_t size, bool references);  // elements zero
[[nodiscard]] Obj* new_reals(Vm& vm, std::span<const double> values);
[[nodiscard]] MatrixObj* new_matrix(Vm& vm, std::uint32_t rows, std::uint32_t cols);  // zero
[[nodiscard]] MatrixObj* new_matrix_unset(Vm& vm, std::uint32_t rows, std::uint32_t cols);
[[nodiscard]] RecordObj* new_record(Vm& vm, const Type* record);       // fields zero
[[nodiscard]] HostObj* new_host_object(Vm& vm, const HostType& type);  // payload not constructed
void retain(Obj* object);
void release(Vm& vm, Obj* object);

template <class T>
[[nodiscard]] Obj* new_host_value(Vm& vm, const HostType& type, T value) {
  HostObj* object = new_host_object(vm, type);
  if (object != nullptr) new (object->payload()) T(std::move(value));
  return object;
}
// Stores a reference as the result; kFail if it is null.
[[nodiscard]] inline Signal give(Slot* args, Obj* object) {
  args[0].o = object;
  return object != nullptr ? Signal::kDone : Signal::kFail;
}
[[nodiscard]] inline Signal give(Slot* args, double value) {
  args[0].d = value;
  return Signal::kDone;
}
[[nodiscard]] inline Signal give(Slot* args, std::int64_t value) {
  args[0].i = value;
  return Signal::kDone;
}
[[nodiscard]] inline Signal give(Slot* args, bool value) {
  args[0].i = value ? 1 : 0;
  return Signal::kDone;
}
// Counts long work as steps, so that limits and stop requests take effect. Called before the work,
// and again during it. Returns false, with the failure set, if the program has to stop.
[[nodiscard]] bool charge_steps(Vm& vm, std::uint64_t steps);
// Temporary memory of a native function, counted for the limit of the heap.
class Scratch {
 public:
  Scratch(Vm& vm, std::uint64_t bytes);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  // False, with the failure set, if the limit was reached.
  [[nodiscard]] bool granted() const { return granted_; }

 private:
  Vm& vm_;
  std::uint64_t bytes_;
  bool granted_;
};
[[nodiscard]] inline Signal give_nothing() { return Signal::kDone; }
Failed fail(Vm& vm, Failure failure);
Signal pause(Vm& vm, std::unique_ptr<Waiting> waiting);

// ---- rules checked before running

// A value that follows from the text: literals, constant variables and lists of these.
struct Constant {
  enum class Kind : std::uint8_t { kBool, kInt, kReal, kText, kList } kind = Kind::kInt;
  bool truth = false;
  std::int64_t integer = 0;
  double real = 0.0;  // also set for kInt
  std::string text{};
  std::vector<Constant> items{};
};

// Knowledge about a value before the run. Rules make it; constant variables pass it on.
class Fact {
 public:
  virtual ~Fact() = default;
  [[nodiscard]] virtual std::string_view kind() const { return {}; }  // a text that is never freed
};

// The size of a matrix, or the length of a list (its rows).
class SizeFact : public Fact {
 public:
  explicit SizeFact(std::int64_t length) : rows(length), is_list(true) {}
  SizeFact(std::int64_t r, std::int64_t c) : rows(r), cols(c) {}

  std::int64_t rows = 0;
  std::int64_t cols = 1;
  bool is_list = false;
};

// One call, as a rule sees it. Arguments are named by their parameters: call.given(at("speed")).
// throws  ArgumentError if the function has no such parameter.
class CheckCall {
 public:
  virtual ~CheckCall() = default;

  [[nodiscard]] virtual std::string_view function_name() const = 0;  // as written: "run"
  // Whether the argument is in the text; absent, default and ambient values are not.
  [[nodiscard]] virtual bool given(CallPart part) const = 0;
  [[nodiscard]] virtual const Type* type(CallPart part) const = 0;  // before conversion
  [[nodiscard]] virtual Span span(CallPart part) const = 0;
  // The span of a named argument with its name, `time: 2s`; without a name that of the value.
  [[nodiscard]] virtual Span setting_span(CallPart part) const = 0;
  [[nodiscard]] virtual Span callee_span() const = 0;
  [[nodiscard]] virtual Span call_span() const = 0;
  [[nodiscard]] virtual std::string text_of(Span span) const = 0;  // as written
  [[nodiscard]] virtual int line_of(Span span) const = 0;
  [[nodiscard]] virtual std::optional<Constant> constant(CallPart part) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Fact> fact(CallPart part) const = 0;
  // The single values of variadic parameters and of rows.
  [[nodiscard]] virtual int item_count(CallPart part) const = 0;
  [[nodiscard]] virtual const Type* item_type(CallPart part, int item) const = 0;
  [[nodiscard]] virtual Span item_span(CallPart part, int item) const = 0;
  [[nodiscard]] virtual std::optional<Constant> item_constant(CallPart part, int item) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Fact> item_fact(CallPart part, int item) const = 0;
  // The fact of the ambient value of a host type ("motor") for a call without a first argument at
  // this position; null if there is no such value, or several.
  [[nodiscard]] virtual std::shared_ptr<const Fact> ambient_fact(
      std::string_view host_type) const = 0;
  // The names of all block declarations of a type in the program: declared_names("object"); and
  // whether there is one with a name. "camera.rate": of the first one that has this row.
  [[nodiscard]] virtual std::vector<std::string> declared_names(std::string_view type) const = 0;
  [[nodiscard]] virtual bool declares(std::string_view type, std::string_view name) const = 0;
  // The position in the text of the literal element `item` of a list argument, found through
  // constant and classic variables and `new T(list)`; an empty span if it is not known.
  [[nodiscard]] virtual Span origin(CallPart part, int item) const = 0;
  // Whether the program's text uses this library function.
  [[nodiscard]] virtual bool mentions(std::string_view function) const = 0;
  // Whether the call is in a `path`; kPerhaps in a function, which a path may call.
  enum class InPath { kNo, kPerhaps, kYes };
  [[nodiscard]] virtual InPath in_path() const = 0;
  // The host's state given when compiling (CompileOptions::host); may be null.
  [[nodiscard]] virtual void* host() const = 0;
  // The names of the world (CompileOptions::world); null: none are known.
  [[nodiscard]] virtual const WorldNames* world() const = 0;
  // The program uses one of these names that it does not declare itself (Program::uses_world).
  virtual void use_world() = 0;

  // This call takes virtual time: it is one of NativeFunction::timed.
  virtual void take_time() = 0;
  virtual void set_result_fact(std::shared_ptr<const Fact> fact) = 0;
  // Whether an error would be shown if it were reported now; if not, its explanation is not needed.
  [[nodiscard]] virtual bool takes_errors() const = 0;
  virtual void report(Diagnostic diagnostic) = 0;
};

}  // namespace armlet
