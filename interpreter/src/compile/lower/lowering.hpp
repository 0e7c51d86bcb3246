#pragma once
// One function of the checked program on its way to bytecode. The parts are in lower_*.cpp.
//
// Numbers are evaluated into number registers, destination first, so that few moves are needed.
// References are either borrowed, when someone else keeps them alive while they are needed, or
// counted into a reference register.

#include <cstdint>
#include <functional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "compile/code/emitter.hpp"
#include "compile/code/tables.hpp"
#include "compile/lower/analysis.hpp"
#include "compile/lower/lower.hpp"
#include "compile/lower/lowering_terms.hpp"

namespace armlet::lang {

class Lowering {
 public:
  Lowering(Tables& tables, const hir::Function& function, LowerOptions options);

  void function(FunctionCode& into);

 private:
  // What `break`, `continue` and `retry` go to.
  struct Exit {
    const hir::Stmt* target;
    Label leave;           // break
    Label again;           // continue, retry
    std::size_t tries;     // how many tries are around it
    Reg retries, instant;  // for RETRY
  };
  struct TryScope {
    const hir::Block* finally;  // null: none
    Reg watches;                // of a watched block; no bits: there are none
    bool catching;              // failures here go to a handler
    std::uint32_t begin;        // of the range that is open
    std::vector<Emitter::Range> caught;
    std::vector<Emitter::Range> finals;
    [[nodiscard]] bool is_watched() const { return watches.bits != 0; }
    [[nodiscard]] bool has_end() const { return finally != nullptr || is_watched(); }
  };
  // A function that stands in place of its call.
  struct Expansion {
    Dest to;    // its result
    Label end;  // where it returns to
  };
  struct StepIndex {
    Reg index;
    Reg column;  // elements of matrices
  };
  using Indices = std::vector<StepIndex>;  // by step of a place; unused for fields
  using Pass = std::function<void()>;

  // ---- lower.cpp
  void start(FunctionCode& into);
  void load_captures(FunctionCode& into);
  void finish(FunctionCode& into);

  // ---- lower_number.cpp: values without a count
  Reg value(const hir::Expr& e);
  Reg value_near(const hir::Expr& e, Dest hint);
  void value_into(const hir::Expr& e, Dest to);
  bool in_register(const hir::Expr& e, Reg& out);
  void compute(const hir::Expr& e, Dest to);
  void read_variable(const hir::VariableExpr& e, Reg to);
  void operator_into(const hir::BinaryExpr& e, Dest to);
  void entry_into(const hir::EntryExpr& e, Reg to);
  void load_variable(const hir::Variable& variable, Reg to);
  void unary_into(const hir::UnaryExpr& e, Dest to);
  void binary_into(const hir::BinaryExpr& e, Dest to);
  void arithmetic(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool multiply_add(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool add_to_product(const hir::BinaryExpr& product, const hir::BinaryExpr& sum, Reg left, Reg to);
  bool with_int(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool with_field(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool turned(const hir::BinaryExpr& e, Reg to);
  bool add_product_of_element(Site site, Reg a, const hir::Expr& b, Reg to);
  bool multiply_element(const hir::Expr& right, Reg accumulator);
  void truth_into(const hir::Expr& e, Dest to);
  void cond_into(const hir::CondExpr& e, Dest to);
  void convert_into(const hir::ConvertExpr& e, Dest to);
  void length_into(const hir::LengthExpr& e, Reg to);
  void load_field(const hir::FieldExpr& e, Reg to, Hold hold);
  void load_element(const hir::ElementExpr& e, Reg to, Hold hold);
  bool load_element_twice(const hir::ElementExpr& e, Reg to, Hold hold);
  // ---- lower_known.cpp
  bool with_small(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool by_power_of_two(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);
  bool with_constant(Site site, hir::Op op, Reg left, const hir::Expr& right, Reg to);

  // ---- lower_reference.cpp: texts, lists, records ...
  Reg borrow(const hir::Expr& e, Hold hold);
  void borrow_into(const hir::Expr& e, Reg to, Hold hold);
  Reg borrow_variable(const hir::Variable& variable, Hold hold);
  Reg null_reference();
  void own_into(const hir::Expr& e, Reg to);
  void own_read(const hir::VariableExpr& e, Reg to);
  void own_variable(const hir::Variable& variable, Reg to);
  void own_either(const hir::CondExpr& e, Reg to);
  void own_converted(const hir::ConvertExpr& e, Reg to);
  void make(const hir::Expr& e, Reg to);
  void make_list(const hir::ListExpr& e, Reg to);
  void make_array(const hir::NewArrayExpr& e, Reg to);
  void make_record(const hir::RecordExpr& e, Reg to);
  void make_function(const hir::FunctionValueExpr& e, Reg to);
  void make_closure(const hir::ClosureExpr& e, Reg to);
  void make_error(const hir::ErrorExpr& e, Reg to);
  void make_slice(const hir::SliceExpr& e, Reg to);
  void make_character(const hir::CharacterExpr& e, Reg to);
  void join(const hir::ConcatExpr& e, Reg to);
  static std::vector<hir::Expr*> joined_parts(const hir::ConcatExpr& e);
  void to_text(const hir::ToTextExpr& e, Reg to);
  // ---- lower_unset.cpp: elements that may have no value yet
  [[nodiscard]] bool may_be_unset(const Type& element) const;
  [[nodiscard]] bool may_hold_unset(const Type& type) const;
  [[nodiscard]] bool leads_through_unset(const hir::Place& place) const;
  void load_item(Reg to, Reg list, Reg index, const Type& element, const hir::Expr& written);
  void check_whole(const hir::Expr& e, Reg value, bool only_itself = false);
  void check_arguments(const hir::CallNativeExpr& e, Reg base);
  // ---- lower_map.cpp
  void make_map(const hir::MapExpr& e, Reg to);
  void make_map_list(const hir::MapQueryExpr& e, Reg to);
  void load_entry(const hir::EntryExpr& e, Reg to, Hold hold);
  void own_entry_or(const hir::EntryExpr& e, Reg to);
  void has_key_into(const hir::MapQueryExpr& e, Reg to);
  Reg key(const hir::Expr& e, Hold hold);
  void step_to_entry(const hir::Step& step, Reg to, Reg key, bool makes);
  Reg remove_key(const hir::MutateExpr& e);
  // ---- lower_matrix.cpp
  void make_matrix(const hir::MatrixExpr& e, Reg to);
  void make_part(const hir::PartExpr& e, Reg to);
  Reg part_ends(std::span<const hir::PartEnds> ends);
  void load_matrix_element(const hir::ElementExpr& e, Reg to, Hold hold);
  void store_part(const hir::StorePartStmt& s);

  // ---- lower_call.cpp
  void window(hir::Seq<hir::Expr*> arguments, Reg base, Hold hold);
  void argument(const hir::Expr& e, Reg slot, Hold hold);
  void call_window(const hir::CallExpr& e, Reg base);
  bool handed_over(const hir::CallExpr& e, std::size_t argument, Hold hold, Reg& from);
  [[nodiscard]] bool may_be_last_use(const hir::Expr& e, const hir::Variable& variable) const;
  Reg base_for(Dest to);
  void call_into(const hir::Expr& e, Dest to);
  void call_own(const hir::Expr& e, Reg to);
  void effect(const hir::Expr& e);
  Reg call(const hir::Expr& e, Dest to);
  Reg call_value(const hir::CallValueExpr& e, Dest to);
  Reg call_native(const hir::CallNativeExpr& e, Reg base);
  Reg call_guarded(const hir::GuardedExpr& e, Dest to);
  bool call_direct(const hir::CallNativeExpr& e, Dest to);
  bool code_of_character(const hir::CallNativeExpr& e, Dest to);
  void character_code(const hir::CharacterExpr& e, Reg to);

  // ---- inlining.cpp
  void expand(const hir::CallExpr& e, Dest to);
  void expand_body(Site site, const hir::Function& function, const std::vector<Reg>& arguments,
                   Dest to);
  void give_back_here(const hir::Expr& e);

  // ---- lower_over_list.cpp: map, filter, fold ...
  using Element = std::function<void(Reg counter)>;
  void over_list(const hir::OverListExpr& e, Reg to);
  Reg held(const hir::OverListExpr& e, std::size_t operand);
  void each(const hir::OverListExpr& e, Reg last, const Element& pass);
  void call_each(const hir::OverListExpr& e, Reg function, Reg base);
  Reg length_of(const hir::OverListExpr& e, Reg list);
  Reg new_list(const hir::OverListExpr& e, const Type* element);
  void add_to(const hir::OverListExpr& e, Reg list, Reg item, const Type* element);
  Reg map_list(const hir::OverListExpr& e, Reg list, const Type* element);
  Reg filter_list(const hir::OverListExpr& e);
  Reg fold_list(const hir::OverListExpr& e);
  Reg test_list(const hir::OverListExpr& e);
  Reg sort_list(const hir::OverListExpr& e);
  Reg zip_lists(const hir::OverListExpr& e);
  Reg find_in_list(const hir::OverListExpr& e);
  void branch_equal(const hir::OverListExpr& e, Reg a, Reg b, Label to);

  // ---- lower_branch.cpp
  void branch(const hir::Expr& e, bool when, Label to);
  void branch_on(Reg truth, bool when, Label to);
  void branch_all(const hir::BinaryExpr& e, bool when, Label to);
  bool branch_compare(const hir::BinaryExpr& e, bool when, Label to);
  void branch_int(const hir::BinaryExpr& e, hir::Op op, Label to);
  void branch_real(const hir::BinaryExpr& e, bool when, Label to);
  bool branch_characters(const hir::BinaryExpr& e, hir::Op op, Label to);
  void branch_text(const hir::BinaryExpr& e, hir::Op op, Label to);
  void branch_deep(const hir::BinaryExpr& e, bool equal, Label to);

  // ---- lower_place.cpp
  void check_set(const hir::Variable& variable);
  void assign(const hir::AssignStmt& s);
  void assign_whole(const hir::AssignStmt& s);
  void assign_compound(const hir::AssignStmt& s);
  void assign_inside(const hir::AssignStmt& s);
  void store(const hir::Variable& variable, const hir::Expr& value);
  void store_register(const hir::Variable& variable, Reg from);
  bool can_write_early(const hir::Variable& variable, const hir::Expr& value) const;
  bool append_text(const hir::Variable& variable, const hir::Expr& value);
  // The right side of a compound assignment, or the two factors of it.
  struct Addend {
    bool is_evaluated = false;
    bool is_product = false;
    Reg first;
    Reg second;
  };
  Addend addend(const hir::AssignStmt& s);
  void add_to(const hir::AssignStmt& s, const Addend& added, Reg to);
  void operate(const hir::AssignStmt& s, Reg left, Reg to);
  bool add_product_inside(const hir::AssignStmt& s, const Indices& indices);
  bool operate_inside(const hir::AssignStmt& s, const Indices& indices);
  [[nodiscard]] bool is_chain_of_objects(const hir::Place& place) const;
  static bool has_key(const hir::Place& place);
  Reg owned_inside(const hir::Place& place, const Indices& indices, Reg object);
  Indices index_values(const hir::Place& place);
  static Hold hold_for(const hir::Place& place, const hir::Expr& value);
  [[nodiscard]] bool can_own(const hir::Variable& variable) const;
  Reg own_register(const hir::Variable& variable);
  void store_inside(const hir::Place& place, const Indices& indices, Reg from);
  Reg address(const hir::Place& place, const Indices& indices, Missing missing = Missing::kFails);
  void load_place(const hir::Place& place, const Indices& indices, Reg to);
  Reg mutate(const hir::MutateExpr& e);

  // ---- lower_stmt.cpp
  void statement(const hir::Stmt& s);
  void block(const hir::Block& b);
  void scoped(const hir::Stmt& s);
  void declare(hir::Variable& variable);
  void init(const hir::InitStmt& s);
  void init_from(hir::Variable& variable, Reg value);
  void note_set(const hir::Variable& variable);
  void if_else(const hir::IfStmt& s);
  void switch_case(const hir::SwitchStmt& s);
  bool switch_by_table(const hir::SwitchStmt& s, const std::vector<Label>& bodies, Label otherwise);
  void jump(const hir::JumpStmt& s);
  void give_back(const hir::ReturnStmt& s);
  void give_back_reference(const hir::Expr& e);
  void raise(const hir::ThrowStmt& s);
  void wait(const hir::WaitStmt& s);
  void wait_until(const hir::WaitUntilStmt& s);
  void check(const hir::AssertStmt& s);

  // ---- lower_loop.cpp
  void begin_loop(const hir::Stmt& s);
  void end_loop(Emitter::Mark mark, std::size_t pinned);
  void pin_globals(const Summary& summary);
  bool pinned_global(const hir::Variable* variable, Reg& out) const;
  void loop(const hir::LoopStmt& s);
  void plain_loop(const hir::LoopStmt& s);
  bool counted_loop(const hir::LoopStmt& s, const Summary& body);
  bool loop_bound(const hir::Expr& e, const Summary& body, Reg& out);
  void count_up(Span test, Reg counter, Reg last, const Pass& pass);
  void range(const hir::RangeStmt& s);
  void range_pass(const hir::RangeStmt& s, Reg counter);
  Reg range_end(const hir::Expr& e, const Summary& body);
  void count_by(const hir::RangeStmt& s, Reg counter, Reg last, RangeStep step, const Pass& pass);
  void for_list(const hir::ForListStmt& s);
  Reg visited_list(const hir::Expr& items, const Summary& body);
  [[nodiscard]] std::uint32_t line_of(Span span) const;

  // ---- lower_try.cpp
  void try_catch(const hir::TryStmt& s);
  void handle(const hir::TryStmt& s);
  void check_throws(const hir::AssertThrowsStmt& s);
  // Leaves the tries above `depth`, running what they do finally, then does `go`.
  void leave(std::size_t depth, const std::function<void()>& go);
  void close(TryScope& scope);
  TryScope pop_try();
  [[nodiscard]] bool finally_runs() const;
  // ---- lower_tasks.cpp
  static bool starts_watching(const hir::Stmt* s);
  void watched_block(hir::Seq<hir::Stmt*> body);
  void parallel(const hir::ParallelStmt& s);
  void when(const hir::WhenStmt& s);
  void every(const hir::EveryStmt& s);

  [[nodiscard]] static Reg reg_of(const hir::Variable& variable) { return Reg{variable.index}; }

  Tables& tables_;
  const hir::Function& function_;
  LowerOptions options_;
  Emitter code_;
  bool is_program_;
  std::vector<Exit> exits_;
  std::vector<TryScope> tries_;
  std::vector<const hir::Variable*> pinned_globals_;  // held in registers during a quiet loop
  std::unordered_map<const hir::Variable*, Reg> pinned_registers_;
  std::vector<Expansion> expansions_;       // the innermost last
  const hir::Expr* whole_ = nullptr;        // all of the value that a statement assigns or returns
  std::vector<const hir::Variable*> lent_;  // lists whose elements a loop borrows
  int loop_depth_ = 0;
};

}  // namespace armlet::lang
