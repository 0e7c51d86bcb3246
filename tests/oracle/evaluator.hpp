#pragma once
// Runs a checked program by walking its typed tree: the slowest and plainest method, to
// compare the machine with.
//
// Values are copied whenever they are read; functions of the text call functions of C++; failures
// are exceptions; a task is a thread. Robots are not here: programs with them end in
// std::logic_error.

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "arithmetic.hpp"
#include "armlet/interpreter/engine.hpp"
#include "bridge.hpp"
#include "program/program.hpp"
#include "tasks.hpp"
#include "value.hpp"

namespace armlet::oracle {

struct Outcome {
  std::string output;
  std::optional<Failure> failure;  // that nobody caught
};

class Aside;

// How a statement ended: normally, jumping to a loop, switch or try, or returning.
struct Completion {
  enum class How : std::uint8_t { kNormal, kJump, kReturn } how = How::kNormal;
  lang::hir::Jump jump{};
  const lang::hir::Stmt* target = nullptr;
  Span where{};  // of the statement that jumps or returns
  Value value{};

  [[nodiscard]] bool is_normal() const { return how == How::kNormal; }
  [[nodiscard]] bool is(lang::hir::Jump wanted, const lang::hir::Stmt& at) const {
    return how == How::kJump && jump == wanted && target == &at;
  }
};

class Evaluator {
 public:
  // host, call_depth  as in VmOptions and RunLimits.
  Evaluator(std::shared_ptr<const Program> program, void* host, std::uint32_t call_depth);

  [[nodiscard]] Outcome run();

 private:
  friend class Aside;
  // A variable has its own memory: tasks share those that they see.
  using Variables = std::unordered_map<const lang::hir::Variable*, std::shared_ptr<Value>>;
  using Values = std::vector<Value>;
  struct Index {
    std::int64_t row = 0;  // or of a list
    std::int64_t column = 0;
    Value key = {};  // of a map
  };
  using Indices = std::vector<Index>;

  // ---- expressions
  [[nodiscard]] Value evaluate(const lang::hir::Expr& e);
  [[nodiscard]] Value evaluate_made(const lang::hir::Expr& e);
  [[nodiscard]] Values evaluate_all(lang::hir::Seq<lang::hir::Expr*> items);
  [[nodiscard]] Value variable(const lang::hir::Variable& v, Span where);
  [[nodiscard]] Value binary(const lang::hir::BinaryExpr& e);
  [[nodiscard]] Value convert(const lang::hir::ConvertExpr& e);
  [[nodiscard]] Value to_text(const lang::hir::ToTextExpr& e);
  [[nodiscard]] Value length(const lang::hir::LengthExpr& e);
  [[nodiscard]] Value character(const lang::hir::CharacterExpr& e);
  [[nodiscard]] Value element(const lang::hir::ElementExpr& e);
  [[nodiscard]] Value slice(const lang::hir::SliceExpr& e);
  [[nodiscard]] Value new_array(const lang::hir::NewArrayExpr& e);
  [[nodiscard]] Value closure(const lang::hir::ClosureExpr& e);
  [[nodiscard]] Value error(const lang::hir::ErrorExpr& e);
  [[nodiscard]] Value mutate(const lang::hir::MutateExpr& e);

  // ---- maps
  [[nodiscard]] Value of_map(const lang::hir::Expr& e);
  [[nodiscard]] Value map(const lang::hir::MapExpr& e);
  [[nodiscard]] Value entry(const lang::hir::EntryExpr& e);
  [[nodiscard]] Value map_query(const lang::hir::MapQueryExpr& e);
  [[nodiscard]] Value remove_key(const lang::hir::MutateExpr& e);
  [[nodiscard]] Value& step_to_entry(Value& map, const lang::hir::Step& step, const Value& key,
                                     bool makes) const;
  [[nodiscard]] static std::string key_text(const Value& key, const Type& type);
  [[noreturn]] void fail_key(const Value& key, const Type& map, Span where) const;

  // ---- matrices and parts
  struct Stretch {
    std::size_t first;
    std::size_t count;
  };
  struct Ends {
    Value first;
    Value last;
    bool is_range;
  };
  [[nodiscard]] Ends ends(const lang::hir::PartEnds& written);
  // Where a part lies in what has this many rows, columns, values.
  [[nodiscard]] Stretch stretch(const Ends& ends, std::size_t size, Span where,
                                const std::string& what) const;
  [[nodiscard]] Value matrix(const lang::hir::MatrixExpr& e);
  [[nodiscard]] Value part(const lang::hir::PartExpr& e);
  void store_part(const lang::hir::StorePartStmt& s);
  void store_in_list(List& to, Stretch part, const List& given, Span where) const;
  void store_in_matrix(Matrix& to, Stretch rows, Stretch cols, const Value& value,
                       Span where) const;
  [[nodiscard]] Value& cell(Value& matrix, Index at, Span where) const;

  // ---- calls
  [[nodiscard]] Value over_list(const lang::hir::OverListExpr& e);
  [[nodiscard]] Value look_up(const lang::hir::OverListExpr& e, const Values& operands);
  [[nodiscard]] Value call_native(const lang::hir::CallNativeExpr& e);
  // depth  how much deeper the calls are nested afterwards.
  [[nodiscard]] Value call(const lang::hir::Function& function, Values arguments,
                           const Captures& captures, Span where, std::uint32_t depth = 1);
  // A call of a function value by a function of the library.
  [[nodiscard]] Value call_back(const Value& function, Values arguments, Span where);
  // Functions that take functions; false: it is none of them.
  [[nodiscard]] bool higher_order(const lang::hir::CallNativeExpr& e, Values& arguments,
                                  Value& result);

  // ---- statements
  [[nodiscard]] Completion execute(const lang::hir::Stmt& s);
  [[nodiscard]] Completion block(const lang::hir::Block& s);
  [[nodiscard]] Completion sequence(const lang::hir::Block& s);  // no more than its statements
  [[nodiscard]] Completion loop(const lang::hir::LoopStmt& s);
  [[nodiscard]] Completion range(const lang::hir::RangeStmt& s);
  [[nodiscard]] Completion for_list(const lang::hir::ForListStmt& s);
  [[nodiscard]] Completion switch_case(const lang::hir::SwitchStmt& s);
  [[nodiscard]] Completion try_catch(const lang::hir::TryStmt& s);
  // The block, and the catch with all its retries.
  [[nodiscard]] Completion attempt(const lang::hir::TryStmt& s);
  void assign(const lang::hir::AssignStmt& s);
  void throw_error(const lang::hir::ThrowStmt& s);
  void check(const lang::hir::AssertStmt& s);
  void check_throws(const lang::hir::AssertThrowsStmt& s);

  // ---- time and tasks
  void time_and_tasks(const lang::hir::Stmt& s);
  void wait(const lang::hir::WaitStmt& s);
  void wait_until(const lang::hir::WaitUntilStmt& s);
  void parallel(const lang::hir::ParallelStmt& s);
  void when(const lang::hir::WhenStmt& s);
  void every(const lang::hir::EveryStmt& s);
  // A block with `when` or `every`, which watch until it is left.
  [[nodiscard]] Completion watched(const lang::hir::Block& s);
  // How times are called in messages: "a wait" and "the time to wait".
  struct TimeNames {
    std::string what;
    std::string time;
    std::string too_short = "time only runs forwards";
  };
  [[nodiscard]] std::int64_t nanoseconds(double seconds, const Type& type, Span where,
                                         const TimeNames& names) const;
  [[nodiscard]] Tasks::Body body_of(const lang::hir::Expr& e);
  [[nodiscard]] Tasks::Condition condition_of(const lang::hir::Expr& e);
  void refuse_to_pause(Span where) const;

  // ---- targets of assignments
  [[nodiscard]] Variables& home(const lang::hir::Variable& v);
  void declare(const lang::hir::Variable& v, Value value);
  void check_set(const lang::hir::Variable& v, Span where);
  [[nodiscard]] Indices indices(const lang::hir::Place& place);
  // makes: the entry of a map that the target ends with, if it is not there.
  [[nodiscard]] Value& walk(const lang::hir::Place& place, const Indices& indices,
                            bool makes = false);

  // ---- elements without a value
  [[nodiscard]] std::string short_text(Span span) const;
  // Where the last pair of brackets begins.
  [[nodiscard]] static std::size_t last_bracket(const std::string& text);
  [[noreturn]] void fail_unset(std::int64_t index, Span list, Span where) const;
  void check_whole(const Value& value, const Type& type, Span where, bool deep = true) const;
  // An element that a loop visits; `where` is the list.
  [[nodiscard]] const Value& set_item(const Value& list, std::size_t index, Span where) const;

  // ---- failures
  [[nodiscard]] std::string text(Span span) const;
  [[noreturn]] void fail(const Headline& headline, Span where) const;
  template <std::size_t N>
  [[noreturn]] void fail(CodeFor<N> code, Span where, const std::string (&words)[N]) const {
    fail(Headline(code, words), where);
  }
  [[noreturn]] void fail_index(std::int64_t index, std::size_t size, Span where,
                               const std::string& what = "list") const;
  [[noreturn]] void fail_backwards(std::int64_t first, std::int64_t last, Span where) const;
  [[noreturn]] void fail_calculation(Trouble trouble, Span where, const Value* a,
                                     const Value* b) const;
  [[nodiscard]] Value calculate_at(lang::hir::Op op, const Value& a, const Value& b,
                                   Span where) const;
  [[nodiscard]] Failure seen(const Failure& failure) const;  // with its time
  [[nodiscard]] Value caught(const Failure& failure) const;
  [[nodiscard]] Value error_record(const std::string& message, const std::string& kind, int line,
                                   double time) const;
  [[nodiscard]] std::string error_field(const Value& error, const char* name) const;

  std::shared_ptr<const Program> program_;
  const SourceSet& sources_;
  Bridge bridge_;
  std::uint32_t most_calls_;
  std::uint32_t calls_ = 0;       // nested now
  std::uint32_t host_calls_ = 0;  // of functions of the library that called back
  Variables globals_;
  Variables* locals_ = nullptr;  // of the running function
  std::string output_;
  Tasks tasks_;  // ends before what they use
};

// Something else runs for a while: afterwards the same function runs again as before.
class Aside {
 public:
  explicit Aside(Evaluator& evaluator)
      : evaluator_(evaluator),
        calls_(evaluator.calls_),
        host_calls_(evaluator.host_calls_),
        locals_(evaluator.locals_) {}
  ~Aside() { go_back(); }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  void go_back() const {
    evaluator_.calls_ = calls_;
    evaluator_.host_calls_ = host_calls_;
    evaluator_.locals_ = locals_;
  }

 private:
  Evaluator& evaluator_;
  std::uint32_t calls_;
  std::uint32_t host_calls_;
  Evaluator::Variables* locals_;
};

}  // namespace armlet::oracle
