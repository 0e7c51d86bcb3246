// Rules of the host, which check a call before the program runs: the view of the call that a rule
// gets.

#include <algorithm>
#include <map>
#include <string>

#include "armlet/core/error.hpp"
#include "check/library/native_calls.hpp"
#include "check/library/overloads.hpp"
#include "check/state/checker.hpp"

namespace armlet::lang {
namespace {

class Call final : public CheckCall {
 public:
  Call(Checker& checker, std::string_view name, const std::vector<Argument>& arguments,
       const Fit& fit, hir::CallNativeExpr& call)
      : checker_(checker), name_(name), arguments_(arguments), fit_(fit), call_(call) {}

  std::string_view function_name() const override { return name_; }
  bool given(CallPart part) const override {
    return written(index_of(part)) != nullptr || !items(index_of(part)).empty();
  }

  const Type* type(CallPart part) const override {
    const hir::Expr* value = written(index_of(part));
    return value != nullptr ? value->type : call_.arguments[index_of(part)]->type;
  }
  Span span(CallPart part) const override {
    const hir::Expr* value = written(index_of(part));
    return value != nullptr ? value->span : call_.site.arguments[index_of(part)];
  }
  Span setting_span(CallPart part) const override { return call_.site.arguments[index_of(part)]; }
  Span callee_span() const override { return call_.site.callee; }
  Span call_span() const override { return call_.site.call; }
  std::string text_of(Span span) const override { return checker_.text_of(span); }
  int line_of(Span span) const override { return checker_.line_of(span); }

  std::optional<Constant> constant(CallPart part) const override {
    return checker_.shared.constants.of(*call_.arguments[index_of(part)]);
  }
  std::shared_ptr<const Fact> fact(CallPart part) const override {
    return shared(fact_of(*call_.arguments[index_of(part)]));
  }

  int item_count(CallPart part) const override {
    return static_cast<int>(items(index_of(part)).size());
  }
  const Type* item_type(CallPart part, int item) const override {
    return items(index_of(part))[item]->type;
  }
  Span item_span(CallPart part, int item) const override {
    return items(index_of(part))[item]->span;
  }
  std::optional<Constant> item_constant(CallPart part, int item) const override {
    return checker_.shared.constants.of(*items(index_of(part))[item]);
  }
  std::shared_ptr<const Fact> item_fact(CallPart part, int item) const override {
    return shared(fact_of(*items(index_of(part))[item]));
  }

  std::shared_ptr<const Fact> ambient_fact(std::string_view host_type) const override {
    return shared(lang::ambient_fact(checker_, host_type));
  }
  std::vector<std::string> declared_names(std::string_view type) const override {
    return checker_.shared.blocks.of(type);
  }
  bool declares(std::string_view type, std::string_view name) const override {
    return checker_.shared.blocks.has(type, name);
  }

  Span origin(CallPart part, int item) const override {
    const hir::Expr* at = &origin_of(*call_.arguments[index_of(part)]);
    // new T(list): the rule sees the list that the value is made from.
    while (at->kind == hir::ExprKind::kCallNative &&
           at->as<hir::CallNativeExpr>().arguments.size() == 1) {
      at = &origin_of(*at->as<hir::CallNativeExpr>().arguments[0]);
    }
    if (at->kind != hir::ExprKind::kList) return {};
    const auto& list = at->as<hir::ListExpr>().items;
    return item >= 0 && item < static_cast<int>(list.size()) ? list[item]->span : Span{};
  }
  bool mentions(std::string_view function) const override {
    return checker_.shared.mentions.has(function);
  }
  InPath in_path() const override {
    const auto is_path = [](const JumpTarget& at) { return at.kind == JumpTarget::Kind::kPath; };
    const FunctionContext* context = &checker_.scopes.here();
    for (; context != nullptr; context = context->outer) {
      if (std::ranges::any_of(context->targets, is_path)) return InPath::kYes;
      const bool is_called = context->kind == FunctionContext::Kind::kNamed ||
                             context->kind == FunctionContext::Kind::kLambda;
      if (is_called) return InPath::kPerhaps;
    }
    return InPath::kNo;
  }
  void* host() const override { return checker_.options.host; }
  const WorldNames* world() const override { return checker_.options.world.get(); }
  void use_world() override { checker_.into.names.of_world = true; }

  void take_time() override {
    if (call_.function->timed == nullptr) return;
    call_.function = call_.function->timed;
    note_pause(checker_, call_.site.call);
  }
  void set_result_fact(std::shared_ptr<const Fact> fact) override {
    call_.fact = fact.get();
    checker_.into.facts.push_back(std::move(fact));
  }
  bool takes_errors() const override { return checker_.messages.takes_errors(); }
  void report(Diagnostic diagnostic) override { checker_.report(std::move(diagnostic)); }

 private:
  int index_of(CallPart part) const {
    if (part.parameter().empty()) return part.operand();
    const Signature& signature = checker_.shared.signatures.of(*call_.function);
    const int index = signature.index_of(part.parameter());
    if (index < 0) {
      refuse_argument('`' + std::string(call_.function->name) +
                      std::string(call_.function->signature) + "` has no parameter `" +
                      std::string(part.parameter()) + "`.");
    }
    return index;
  }

  // The argument in the text, before its conversion; null if it is not in the text.
  const hir::Expr* written(int parameter) const {
    if (parameter < 0 || parameter >= static_cast<int>(fit_.from.size())) return nullptr;
    const int from = fit_.from[parameter];
    return from >= 0 ? arguments_[from].value : nullptr;
  }

  // The arguments of a variadic parameter, or of a list of rows.
  const std::vector<const hir::Expr*>& items(int parameter) const {
    const auto [known, is_new] = items_.try_emplace(parameter);
    std::vector<const hir::Expr*>& out = known->second;
    if (!is_new) return out;
    const Parameter& declared =
        checker_.shared.signatures.of(*call_.function).parameters[parameter];
    if (declared.variadic) {
      for (const int rest : fit_.rest) out.push_back(arguments_[rest].value);
    } else if (const hir::Expr* value = written(parameter)) {
      const hir::Expr& list = origin_of(*value);
      if (list.kind == hir::ExprKind::kList) {
        const auto& values = list.as<hir::ListExpr>().items;
        out.assign(values.begin(), values.end());
      }
    }
    return out;
  }

  // Facts exist as long as the program.
  static std::shared_ptr<const Fact> shared(const Fact* fact) {
    return {std::shared_ptr<const Fact>(), fact};
  }

  Checker& checker_;
  std::string_view name_;
  const std::vector<Argument>& arguments_;
  const Fit& fit_;
  hir::CallNativeExpr& call_;
  // The items of the parameters that a rule has asked for.
  mutable std::map<int, std::vector<const hir::Expr*>> items_;
};

}  // namespace

hir::Expr* run_rule(Checker& checker, std::string_view name, const std::vector<Argument>& arguments,
                    const Fit& fit, hir::CallNativeExpr* call) {
  const auto failed_value = [](const hir::Expr* value) { return value->type->is(Kind::kAny); };
  if (call->function->check == nullptr || std::ranges::any_of(call->arguments, failed_value))
    return call;
  Call seen(checker, name, arguments, fit, *call);
  call->function->check(seen);
  return call;
}

}  // namespace armlet::lang
