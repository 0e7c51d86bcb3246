// Calls of functions of the text and of the library.

#include <algorithm>

#include "evaluator.hpp"
#include "show.hpp"

namespace armlet::oracle {

using namespace lang::hir;

Evaluator::Evaluator(std::shared_ptr<const Program> program, void* host, std::uint32_t call_depth)
    : program_(std::move(program)),
      sources_(program_->sources()),
      bridge_(program_, host),
      most_calls_(call_depth) {}

Outcome Evaluator::run() {
  Outcome outcome;
  Variables locals;
  try {
    tasks_.run([&] {
      locals_ = &locals;
      (void)block(*program_->compiled().module.main->body);
    });
  } catch (const Failure& failure) {
    outcome.failure = failure;
  }
  outcome.output = std::move(output_);
  return outcome;
}

Value Evaluator::call(const Function& function, Values arguments, const Captures& captures,
                      Span where, std::uint32_t depth) {
  if (calls_ + depth > most_calls_) {
    const std::string name(function.name);
    fail("R0624", where, {std::to_string(most_calls_), name.empty() ? "the program" : name});
  }
  Variables locals;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    locals[function.parameters[i]] = std::make_shared<Value>(std::move(arguments[i]));
  }
  for (std::size_t i = 0; i < captures.size(); ++i)
    locals[function.captures[i].inner] = captures[i];
  const Aside aside(*this);
  locals_ = &locals;
  calls_ += depth;
  Completion completion = block(*function.body);
  return std::move(completion.value);
}

Value Evaluator::call_back(const Value& function, Values arguments, Span where) {
  const Aside aside(*this);
  ++host_calls_;
  const Function& called = *function.closure().function;
  Value result = call(called, std::move(arguments), function.closure().captures, where, 2);
  if (called.result != nullptr) check_whole(result, *called.result, where);
  return result;
}

Value Evaluator::call_native(const CallNativeExpr& e) {
  Values arguments = evaluate_all(e.arguments);
  const std::string_view name = e.function->name;
  if (name == "new") {
    const std::int64_t size = arguments[0].integer();
    if (size >= 0) return {List{Values(static_cast<std::size_t>(size), arguments[1])}};
  } else if (name != "last") {
    for (std::size_t i = 0; i < arguments.size(); ++i)
      check_whole(arguments[i], *e.arguments[i]->type, e.arguments[i]->span);
  }
  if (name == "print") {
    output_ += arguments[0].text();
    return {};
  }
  if (name == "now") return {static_cast<double>(tasks_.now_ns()) * 1e-9};
  if (name == "last") {
    const Values& items = arguments[0].list().items;
    const Span list = e.site.arguments[0].empty() ? e.site.call : e.site.arguments[0];
    if (!items.empty() && items.back().absent())
      throw Failure{"R0623", "the last element of this list is read before it has a value", "",
                    list};
    if (!items.empty()) return items.back();
    throw Failure{"R0606", "an empty list has no last value", "IndexError", list};
  }
  Value result;
  if (higher_order(e, arguments, result)) return result;
  return bridge_.call(e, arguments);
}

bool Evaluator::higher_order(const CallNativeExpr& e, Values& arguments, Value& result) {
  const std::string_view name = e.function->name;
  if (name == "reverse") {
    std::ranges::reverse(arguments[0].list().items);
    result = std::move(arguments[0]);
    return true;
  }
  if (name == "twice") {
    const Value once = call_back(arguments[0], {arguments[1]}, e.span);
    result = call_back(arguments[0], {once}, e.span);
    return true;
  }
  return false;
}

}  // namespace armlet::oracle
