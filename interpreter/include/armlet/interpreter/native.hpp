#pragma once
// How a host adds functions, values and rules to the language.
//
// A function is declared by its signature in the notation of the language reference, section 19:
//     {"run", "(m: motor, to: point, time: time?, speed: speed?) -> Run", help, example, &run}
//
//   name: type            required;  name: type = literal  default;  name: type?  may be left out
//   values: number...     any number of trailing numbers, passed as one double[]
//   D, E                  any quantity or double; D^2, D*E, D/E; D[], (D*E)[] lists of it
//   table                 any table, whatever its columns
//   T, U                  any type; fn(T) -> U; as a result Pair{first: T, second: U}
//   point or double[]     is declared as two overloads, "to: point" and "to: double[]"
//
// Names with a meaning of their own:
//   "point.x", "point[]"  the field x of a point; indexing: "point.sharp[]" of the kind sharp,
//                         "point[:]" a part. "point.x=" and "point[]=" give the value that
//                         `p.x = v` and `p[i] = v` store, made from the old one.
//   "operator*"           and its like: operators between host types or lists
//   "motor{}"             what a block declaration of type motor calls. Its parameter `name` gets
//                         the declared name, a parameter `phase: phaseRow[]` the rows
//                         `phase wound(...)`, each made by "motor.phase.wound".
//   "motor.phase.NAME"    makes rows that the program names, `phase u(...)`: it gets the name as
//                         `name`; its `value`, or else its function, is the variable `m.u` that the
//                         host may set. "motor{}" gets all of them in order as `rows`.
//   "motor()", "Math.sqrt"  the ambient motor of the host; a function in a namespace
//   "with.speed"          sets what `with (speed: x)` says; "with{" opens the settings of the
//                         block, "with}" restores the former ones, however the block is left.
//   "path.blend"          likewise for `path`: "path{", "path}"; "path{move}" makes its motions

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
#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/interpreter/failure.hpp"
#include "armlet/interpreter/object.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet {

class CheckCall;
struct WorldNames;

struct NativeFunction {
  std::string_view name;
  std::string_view signature;
  std::string_view help;     // one or two sentences
  std::string_view example;  // one line that runs
  Thunk thunk{};             // null for map, filter ...: the program itself runs these, as loops
  // The same function for a direct call, when its result depends on nothing but its arguments:
  // repeated calls may be left out. When it gives no number the thunk is asked, which may fail.
  double (*real1)(double) = nullptr;
  double (*real2)(double, double) = nullptr;
  void (*check)(CheckCall& call) = nullptr;  // rules checked before running
  // Same arguments -> text: why the result was false (for assert). Further lines are how to show
  // the arguments that are not written as literals, in their order. Of a function whose result is
  // no bool: how the result comes about or why there is none; explain(f(x)) calls this.
  Thunk explain{};
  bool pauses = false;  // takes virtual time: not allowed in conditions
  // Commands its first argument, a resource, like what pauses: no other task may command it then.
  bool commands = false;
  // Pauses, but is meant for a resource that another task commands.
  bool interrupts = false;
  double (*real3)(double, double, double) = nullptr;  // as real1 and real2
  bool acts = false;                                  // gives a value, and changes the world
  bool starts = false;  // the functions that it is given run as tasks, which may take time
  // May stand in a `path`, which otherwise holds nothing that acts or takes time: a motion that is
  // collected there, or a setting that moves obey when they are collected.
  bool in_path = false;
  // The same function, which pauses, for calls that take time by its rule (CheckCall::take_time).
  const NativeFunction* timed = nullptr;
  // Of a function that `def` made: its parameters in the order of the signature, and its result.
  std::span<const ValueKind> takes{};
  const ValueKind* gives = nullptr;  // null: it was not made by `def`
};

// A named number of the library: PI, E.
struct NativeConstant {
  std::string_view name;
  double value = 0.0;  // SI
  Dim dim;
  std::string_view help;
};

// Something that takes virtual time, from a pausing call until it is over.
class Waiting {
 public:
  virtual ~Waiting() = default;
  // The virtual time (ns) at which it ends if nothing interferes; may change when it is stopped.
  [[nodiscard]] virtual std::int64_t due_ns() const = 0;
  [[nodiscard]] virtual bool is_over() const = 0;
  // Stops under control (a guard came true, the task is cancelled); is_over is true at due_ns.
  virtual void stop() = 0;
  // Something to do on the way, at an instant that due_ns named; work() does it as the task that
  // waits. Returns false if it fails: the failure is set in the Vm.
  [[nodiscard]] virtual bool has_work() const { return false; }
  virtual bool work(Vm&) { return true; }
  // Called once when over: leaves the result and returns kDone, or fails.
  virtual Signal finish(Vm& vm, Slot& result) = 0;
  // For reports about stuck programs: "run of left".
  [[nodiscard]] virtual std::string what() const = 0;
  // The resource that is commanded meanwhile; its type is null if none is.
  [[nodiscard]] virtual Resource resource() const { return {}; }
};

// The virtual clock that the host owns.
class Timeline {
 public:
  virtual ~Timeline() = default;
  [[nodiscard]] virtual std::int64_t now_ns() const = 0;
  [[nodiscard]] virtual std::int64_t tick_ns() const = 0;  // how often conditions are looked at
  // Brings the host to time t >= now, or to an earlier one: then it is asked again, so that stop
  // requests are heard in between. Returns false if the host wants the program to stop.
  virtual bool advance_to(std::int64_t t_ns) = 0;
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
// The rows of a table in the order of time. Each is a record of the type that the table's type
// names as its row: the time, then one field per column.
[[nodiscard]] inline std::span<const Slot> table_rows(Slot table) {
  const auto* record = static_cast<const RecordObj*>(table.o);
  return items_value(record->fields()[record->layout->type->record->fields.size()]);
}
// Objects are counted and limited; nullptr: the heap limit was reached, and the failure is set.
[[nodiscard]] Obj* new_text(Vm& vm, std::string_view text);
// How many characters a text has, counted once as work. False: the failure is set.
[[nodiscard]] bool text_length(Vm& vm, Slot text, std::int64_t& characters);
// Its characters from `first` up to but excluding `last`, which it has, in a time that does not
// depend on where they stand; null: the failure is set.
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
// Leaves a reference as the result; kFail if it is null.
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
// Long work counts as steps, so that limits and stop requests reach it: before the work, and again
// while it goes on. False: the program has to stop and the failure is set.
[[nodiscard]] bool charge_steps(Vm& vm, std::uint64_t steps);
// Memory of a function while it works, counted against the heap limit.
class Scratch {
 public:
  Scratch(Vm& vm, std::uint64_t bytes);
  ~Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  // False: the limit was reached and the failure is set.
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

// A value known from the text: literals, fixed variables and lists made of them.
struct Constant {
  enum class Kind : std::uint8_t { kBool, kInt, kReal, kText, kList } kind = Kind::kInt;
  bool truth = false;
  std::int64_t integer = 0;
  double real = 0.0;  // also set for kInt
  std::string text{};
  std::vector<Constant> items{};
};

// What is known of a value before running. Made by rules, carried along by fixed variables.
class Fact {
 public:
  virtual ~Fact() = default;
  [[nodiscard]] virtual std::string_view kind() const { return {}; }  // a text that lasts
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

// One call seen by a rule. Parameters are numbered as in the signature (the ambient first one
// included).
class CheckCall {
 public:
  virtual ~CheckCall() = default;

  [[nodiscard]] virtual std::string_view function_name() const = 0;  // as written: "run"
  // Absent, defaulted and ambient ones are not.
  [[nodiscard]] virtual bool given(int parameter) const = 0;
  [[nodiscard]] virtual const Type* type(int parameter) const = 0;  // before conversion
  [[nodiscard]] virtual Span span(int parameter) const = 0;
  // The value with the name in front of it, if it has one: `time: 2s`.
  [[nodiscard]] virtual Span setting_span(int parameter) const = 0;
  [[nodiscard]] virtual Span callee_span() const = 0;
  [[nodiscard]] virtual Span call_span() const = 0;
  [[nodiscard]] virtual std::string text_of(Span span) const = 0;  // as written
  [[nodiscard]] virtual int line_of(Span span) const = 0;
  [[nodiscard]] virtual std::optional<Constant> constant(int parameter) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Fact> fact(int parameter) const = 0;
  // Variadic parameters and rows: their items one by one.
  [[nodiscard]] virtual int item_count(int parameter) const = 0;
  [[nodiscard]] virtual const Type* item_type(int parameter, int item) const = 0;
  [[nodiscard]] virtual Span item_span(int parameter, int item) const = 0;
  [[nodiscard]] virtual std::optional<Constant> item_constant(int parameter, int item) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const Fact> item_fact(int parameter, int item) const = 0;
  // The fact of the ambient value of a host type ("motor") at this place, which a call without a
  // first argument would use; null if there is none or several.
  [[nodiscard]] virtual std::shared_ptr<const Fact> ambient_fact(
      std::string_view host_type) const = 0;
  // Names of all block declarations of a type in the program: declared_names("object"), and
  // whether there is one of a name. "camera.rate": of the first one that has this row.
  [[nodiscard]] virtual std::vector<std::string> declared_names(std::string_view type) const = 0;
  [[nodiscard]] virtual bool declares(std::string_view type, std::string_view name) const = 0;
  // Where the literal element `item` of a list argument was written, following fixed and classic
  // variables and `new T(list)`; empty span if it cannot be known.
  [[nodiscard]] virtual Span origin(int parameter, int item) const = 0;
  // Whether the program's text mentions this library function anywhere.
  [[nodiscard]] virtual bool mentions(std::string_view function) const = 0;
  // Whether the call stands in a `path`; in a function it perhaps does, when that is called there.
  enum class InPath { kNo, kPerhaps, kYes };
  [[nodiscard]] virtual InPath in_path() const = 0;
  // The host's state given when compiling (CompileOptions::host); may be null.
  [[nodiscard]] virtual void* host() const = 0;
  // The names of the world given when compiling (CompileOptions::world); null: nothing is known.
  [[nodiscard]] virtual const WorldNames* world() const = 0;
  // The program means one of them that it does not declare itself (Program::uses_world).
  virtual void use_world() = 0;

  // This call takes virtual time: it is one of NativeFunction::timed.
  virtual void take_time() = 0;
  virtual void set_result_fact(std::shared_ptr<const Fact> fact) = 0;
  // Whether an error that is reported now will be told: one that will not needs no explanation.
  [[nodiscard]] virtual bool takes_errors() const = 0;
  virtual void report(Diagnostic diagnostic) = 0;
};

}  // namespace armlet
