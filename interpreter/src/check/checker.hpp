#pragma once
// One pass over a program, from the syntax tree to the typed tree. The parts are in the files named
// before each group.
//
// What failed has the type `any`, which fits everywhere, so that one mistake gives one message.
// Statement by statement the sink drops what follows a first message.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/calls/call.hpp"
#include "check/names/suggest.hpp"
#include "check/state.hpp"

namespace armlet::lang {

struct Checker : CheckerState {
  using CheckerState::CheckerState;

  // ---- check.cpp
  void begin();
  void check_top_level();

  // ---- messages.cpp
  void report(Diagnostic diagnostic);
  hir::Expr* failed(Span span);
  hir::Expr* not_available(Span span, std::string_view feature);
  // Something of the language that is checked but cannot run yet (E0199), reported once when all
  // else is checked.
  void note_later(Span span, std::string feature);
  void report_later();
  [[nodiscard]] std::string text_of(Span span) const;
  [[nodiscard]] int line_of(Span span) const;
  [[nodiscard]] std::string line_name(Span span) const;
  // Reports E0201 with the best suggestion.
  hir::Expr* unknown_name(std::string_view name, Span span, const Type* expected = nullptr);
  [[nodiscard]] std::optional<Fix> did_you_mean(std::string_view name, Span span,
                                                const Type* wanted) const;
  [[nodiscard]] std::optional<Fix> did_you_mean(std::string_view name, Span span,
                                                const std::vector<std::string_view>& names) const;
  hir::Expr* mismatch(const hir::Expr& value, const Target& target);

  // ---- mismatch_units.cpp
  void plain_number_for_quantity(const hir::Expr& value, const Target& target);
  void quantity_for_number(const hir::Expr& value);
  void other_quantity(const hir::Expr& value, const Target& target);
  bool variable_named_like_a_unit(const hir::Expr& value, const Target& target);

  // ---- conversions.cpp
  // The value as `type`; null if none of the five conversions leads there.
  hir::Expr* convert(hir::Expr* value, const Type* type);
  hir::Expr* require(hir::Expr* value, const Target& target);
  hir::Expr* check_as(const ast::Expr& expr, const Target& target);
  hir::Expr* condition(const ast::Expr& expr);
  hir::Expr* number_as(hir::Expr* value, const Type* type);
  hir::Expr* cast(hir::Expr* value, const Type* type, Span span);
  [[nodiscard]] const Type* common_type(const hir::Expr& a, const hir::Expr& b);

  // ---- types.cpp
  const Type* resolve(const ast::TypeExpr& type);
  const Type* resolve_named(const ast::TypeExpr& type);
  const Type* resolve_product(const ast::TypeExpr& type);
  const Type* type_called(std::string_view name);

  // ---- expressions.cpp
  hir::Expr* check(const ast::Expr& expr, const Type* expected = nullptr);
  hir::Expr* check_value(const ast::Expr& expr, const Type* expected = nullptr);  // not void
  hir::Expr* check_any(const ast::Expr& expr, const Type* expected);
  hir::Expr* check_literal(const ast::Expr& expr);
  hir::Expr* check_name(const ast::NameExpr& name, const Type* expected);
  hir::Expr* read(Local& local, FunctionContext& where, Span span);
  hir::Expr* check_conditional(const ast::CondExpr& cond, const Type* expected);
  hir::Expr* check_list(const ast::Expr& expr, ast::Seq<ast::Expr*> items, const Type* expected);
  hir::Expr* check_new_array(const ast::NewArrayExpr& expr);
  hir::Expr* check_until(const ast::UntilExpr& until);
  hir::Expr* check_formatted(const ast::FormattedExpr& text);  // formatted.cpp
  hir::Expr* in_format(hir::Expr* value, const ast::FormatSpec& format);
  hir::Expr* to_text(hir::Expr* value);

  // ---- members.cpp
  hir::Expr* check_member(const ast::MemberExpr& member, const Type* expected = nullptr);
  hir::Expr* check_type_member(const ast::MemberExpr& member, std::string_view name);
  hir::Expr* field_of(hir::Expr* object, const ast::MemberExpr& member);
  hir::Expr* unknown_field(const hir::Expr& object, const ast::Name& field);
  hir::Expr* last_of(hir::Expr* list, Span span);
  hir::Expr* enum_name(hir::Expr* value, Span span);
  hir::Expr* check_index(const ast::IndexExpr& index);
  hir::Expr* index_value(const ast::Expr& expr);

  // ---- operators.cpp
  hir::Expr* check_unary(const ast::UnaryExpr& unary, const Type* expected);
  hir::Expr* check_binary(const ast::BinaryExpr& binary, const Type* expected);
  hir::Expr* combine(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
  hir::Expr* arithmetic(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
  void advise_whole_quotient(Span whole, Span left, Span right, const std::string& value);
  hir::Expr* raise(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
  const Type* power_of(const Type* quantity, const hir::Expr& exponent, Span whole);
  hir::Expr* raise_elements(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
  hir::Expr* compare(const ast::BinaryExpr& node, hir::Expr* left, hir::Expr* right);
  hir::Expr* operator_native(std::string_view op, Span op_span, Span span,
                             std::vector<hir::Expr*> operands);
  hir::Expr* no_operator(const ast::BinaryExpr& node, const hir::Expr& left,
                         const hir::Expr& right);
  hir::Expr* different_dimensions(const ast::BinaryExpr& node, const hir::Expr& left,
                                  const hir::Expr& right);

  // ---- constants.cpp
  [[nodiscard]] std::optional<Constant> constant_of(const hir::Expr& expr, int depth = 0) const;
  void note_constant(const hir::Variable& variable);
  [[nodiscard]] const Fact* fact_of(const hir::Expr& expr) const;
  // The expression behind fixed variables.
  [[nodiscard]] const hir::Expr& origin_of(const hir::Expr& expr) const;
  hir::Expr* literal_of(const Constant& constant, const Type* type, Span span);
  hir::Expr* folded(hir::BinaryExpr* expr);

  // ---- calls.cpp
  hir::Expr* check_call(const ast::CallExpr& call, const Type* expected);
  hir::Expr* call_by_name(const ast::CallExpr& call, std::string_view name, Span callee,
                          const Type* expected);
  hir::Expr* call_member(const ast::CallExpr& call, const ast::MemberExpr& member);
  hir::Expr* call_function(std::string_view name, Span callee, Span span,
                           std::vector<Argument> arguments);
  hir::Expr* call_value(hir::Expr* function, const ast::CallExpr& call);
  hir::Expr* check_new_object(const ast::NewObjectExpr& expr);
  std::vector<Argument> arguments_of(ast::Seq<ast::Arg> args, std::string_view callee);
  [[nodiscard]] bool waits(const ast::Expr& expr);
  const Type* list_hint(std::string_view callee, const ast::Arg& arg, std::size_t position);
  // "System.out" for a chain of names that are no variables; empty otherwise.
  [[nodiscard]] std::string dotted_name(const ast::Expr& expr);

  // ---- intrinsics.cpp
  hir::Expr* intrinsic(const ast::CallExpr& call, std::string_view name, Span callee, bool& known);
  hir::Expr* print_call(const ast::CallExpr& call, bool line);
  hir::Expr* last_call(hir::Expr* list, Span span);
  hir::Expr* error_call(const ast::CallExpr& call);
  hir::Expr* conversion_call(const ast::CallExpr& call, const Type* type, std::string_view name);
  hir::Expr* builtin_method(hir::Expr* object, const ast::CallExpr& call,
                            const ast::MemberExpr& member, bool& known);
  hir::Expr* mutation(const ast::CallExpr& call, const ast::MemberExpr& member,
                      hir::Mutation mutation);
  bool takes(const ast::CallExpr& call, std::string_view name, std::size_t least, std::size_t most);

  // ---- overloads.cpp
  const Signature& signature_of(const NativeFunction& function);
  [[nodiscard]] Fit fit(const Signature& signature, const std::vector<Argument>& arguments,
                        bool ambient);
  bool place_arguments(const Signature& signature, const std::vector<Argument>& arguments,
                       Fit& fit) const;
  void match_argument(const Signature& signature, const std::vector<Argument>& arguments,
                      int argument, int parameter, Fit& fit);
  bool fit_waiting(const ast::Expr& written, const TypePattern& pattern);
  // The best of all; null after a message.
  const NativeFunction* choose(std::string_view name,
                               std::span<const NativeFunction* const> candidates, Span callee,
                               Span span, const std::vector<Argument>& arguments, Fit& best);
  void report_misfit(std::string_view name, const Signature& signature, Span callee, Span span,
                     const std::vector<Argument>& arguments, const Fit& fit);  // misfits.cpp
  void report_unknown_setting(std::string_view name, const Signature& signature, const Argument& at,
                              bool ambient);
  void report_count(std::string_view name, const Signature& signature, Span callee,
                    const std::vector<Argument>& arguments, const Fit& fit);
  void report_argument(std::string_view name, const Signature& signature, Span span,
                       const std::vector<Argument>& arguments, const Fit& fit);

  // ---- native_calls.cpp
  hir::Expr* call_native(std::string_view name, std::span<const NativeFunction* const> candidates,
                         Span callee, Span span, std::vector<Argument> arguments);
  hir::Expr* finish_native(std::string_view name, const NativeFunction& function, Span callee,
                           Span span, std::vector<Argument>& arguments, Fit& fit);
  hir::Expr* waiting_argument(std::string_view name, const Argument& argument,
                              const TypePattern& pattern, Bindings& bindings);
  hir::Expr* ambient_value(const HostType& type, Span callee);
  [[nodiscard]] const Fact* ambient_fact(std::string_view type);
  // The variables that a call without its first argument may mean, and the names of all that it
  // could mean. all: every name that it could mean, not only two that differ.
  Ambient find_ambient(const HostType& type, bool all = false);
  void note_pause(Span span);
  hir::Expr* run_rule(std::string_view name, const std::vector<Argument>& arguments, const Fit& fit,
                      hir::CallNativeExpr* call);  // rules.cpp

  // ---- script_calls.cpp
  hir::Expr* call_script(FunctionDecl& function, Span callee, Span span,
                         std::vector<Argument> arguments);
  hir::Expr* construct(const StructDecl& structure, Span callee, Span span,
                       std::vector<Argument> arguments);
  // The arguments by parameter; empty with a message if they do not fit.
  std::optional<std::vector<Argument*>> by_parameter(std::string_view name,
                                                     ast::Seq<ast::Param> parameters, Span callee,
                                                     Span span, std::vector<Argument>& arguments);

  // ---- functions.cpp
  Instance* instance_of(FunctionDecl& function, std::vector<const Type*> types, Span call);
  void check_body(Instance& instance);
  hir::Block* value_body(const ast::Expr& expr, FunctionContext& context);
  void finish_result(FunctionContext& context, std::string_view name, Span end);
  hir::Expr* function_value(FunctionDecl& function, const Type* expected, Span span);
  hir::Function* new_function(std::string_view name, Span span);
  Use& use_of(const hir::Function* function) { return uses_[function]; }
  hir::Expr* check_lambda(const ast::LambdaExpr& lambda, const Type* expected);  // lambdas.cpp
  std::optional<std::vector<hir::Variable*>> lambda_parameters(const ast::LambdaExpr& lambda,
                                                               const Type* expected,
                                                               hir::Function* owner);
  hir::Expr* check_guard(const ast::Expr& condition);  // a condition as a function
  hir::Expr* closure(hir::Function* function, FunctionContext& context, const Type* type,
                     Span span);
  void make_global(hir::Variable& variable);
  hir::Variable* captured(Local& local, FunctionContext& owner, FunctionContext& here);

  // ---- places.cpp
  std::optional<hir::Place> check_place(const ast::Expr& expr, Span statement, bool whole);
  void refuse_place(const ast::Expr& root, const ast::Expr& expr, Span statement);
  std::optional<hir::Step> check_place_step(const ast::Expr& at, const Type* type, Span whole);
  bool may_change(Local& local, FunctionContext& where, Span statement, bool whole);
  void report_copy(const Local& local, Span statement);
  hir::Stmt* check_assign(const ast::AssignStmt& assign);
  hir::Stmt* assign_one(const ast::Expr& target, const ast::AssignStmt& assign);
  hir::Stmt* assign_many(const ast::AssignStmt& assign);
  hir::Stmt* assign_compound(const ast::AssignStmt& assign);
  hir::Stmt* check_step(const ast::StepStmt& step);
  hir::Expr* read_place(const hir::Place& place);

  // ---- statements.cpp
  hir::Block* check_block(ast::Seq<ast::Stmt*> body, Span span);
  void check_into(ast::Seq<ast::Stmt*> body, std::vector<hir::Stmt*>& out);
  static void append(const ast::Stmt& stmt, hir::Stmt* checked, std::vector<hir::Stmt*>& out);
  hir::Stmt* check_statement(const ast::Stmt& stmt);
  hir::Stmt* check_any_statement(const ast::Stmt& stmt);
  hir::Stmt* check_expression_statement(const ast::ExprStmt& stmt);
  hir::Stmt* check_if(const ast::IfStmt& stmt);
  hir::Stmt* check_return(const ast::ReturnStmt& stmt);
  hir::Stmt* return_value(hir::Expr* value, Span span);
  hir::Stmt* check_jump(const ast::Stmt& stmt);
  hir::Stmt* check_throw(const ast::ThrowStmt& stmt);
  hir::Expr* seconds(const ast::Expr& written, std::string_view what);
  hir::Stmt* check_wait(const ast::Expr& duration, Span span);
  hir::Stmt* check_wait_until(const ast::WaitUntilStmt& stmt);
  hir::Stmt* check_try(const ast::TryStmt& stmt);
  // loops.cpp
  hir::Stmt* check_loop(const ast::Stmt& stmt);
  hir::Stmt* check_while(const ast::Expr* condition, const ast::Stmt& body,
                         ast::Seq<ast::Stmt*> step, Span span);
  hir::Stmt* check_do(const ast::DoStmt& stmt);
  hir::Stmt* check_for(const ast::ForStmt& stmt);
  hir::Stmt* check_for_in(const ast::ForInStmt& stmt);
  hir::Stmt* check_range(const ast::ForInStmt& stmt, const ast::CallExpr& range);
  hir::Stmt* loop_body(const hir::Stmt* loop, const ast::Stmt& body, bool endless);
  // switches.cpp
  hir::Stmt* check_switch(const ast::SwitchStmt& stmt);
  hir::Expr* case_test(hir::Variable* subject, const ast::Expr& value, std::set<std::string>& seen);
  void missing_cases(const ast::SwitchStmt& stmt, const Type* type,
                     const std::set<std::string>& seen);
  void advise_missing_break(const ast::SwitchStmt& stmt);
  // asserts.cpp
  hir::Stmt* check_assert(const ast::CallExpr& call);
  hir::Stmt* check_assert_throws(const ast::CallExpr& call);
  void split_condition(hir::AssertStmt& stmt, hir::Expr* condition);

  // ---- declarations.cpp
  void collect(const ast::Block& program);
  void look_ahead(const ast::Block& program);  // check.cpp
  const HostType* ambient_type(const ast::TypeExpr* type, const ast::Expr* init);
  void check_functions();
  void collect_types(const ast::Block& program);
  void collect_functions(const ast::Block& program);
  void refuse_endless();
  void fill_struct(const ast::StructStmt& node);
  hir::Stmt* check_var(const ast::VarStmt& stmt);
  hir::Stmt* declare(const ast::VarStmt& stmt, const ast::Declarator& declarator);
  hir::Stmt* check_object(const ast::ObjectStmt& stmt);  // block_declarations.cpp
  hir::Expr* block_value(const ast::ObjectStmt& stmt, const Type* type);
  std::vector<Argument> block_rows(const ast::ObjectStmt& stmt);
  void add_missing_rows(const NativeFunction& maker, Span span, std::vector<Argument>& arguments);
  hir::Expr* block_row(const ast::ObjectStmt& stmt, const ast::BlockItem& item);
  hir::Stmt* check_test(const ast::TestStmt& stmt);
  void check_waiting_tests();
  hir::Variable* new_variable(std::string_view name, const Type* type, Span span);
  hir::Variable* hidden(const Type* type, Span span);
  Local* add_local(hir::Variable* variable, Declared how, Span keyword);
  bool is_free(const ast::Name& name, const ast::Expr* value = nullptr, Span keyword = {});
  void advise_hidden(const ast::Name& name);
  void open_block() { here_->blocks.push_back(here_->locals.size()); }
  void close_block();

  // ---- usage.cpp
  void finish_usage();
  void mark_unset_globals();
  void prepare_tests();
  void check_conditions();
  [[nodiscard]] bool may_pause(const Use& use);

  // ---- names
  Local* find_local(std::string_view name, FunctionContext*& where);
  FunctionDecl* find_function(std::string_view name);
};

}  // namespace armlet::lang
