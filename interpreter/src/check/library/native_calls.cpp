#include "check/library/native_calls.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "armlet/interpreter/resource.hpp"
#include "armlet/interpreter/unit.hpp"
#include "check/explain/pauses.hpp"
#include "check/library/explained.hpp"
#include "check/library/over_list.hpp"
#include "check/library/overloads.hpp"
#include "check/names/loaded_tables.hpp"
#include "check/names/reading.hpp"
#include "check/names/unknown_names.hpp"
#include "check/state/checker.hpp"
#include "check/state/constants.hpp"
#include "check/state/learnt.hpp"

namespace armlet::lang {

namespace {

hir::Expr* finish_native(Checker& checker, std::string_view name, const NativeFunction& function,
                         Span callee, Span span, std::vector<Argument>& arguments, Fit& fit);
hir::Expr* guessed_call(Checker& checker, std::string_view name,
                        std::span<const NativeFunction* const> candidates, Span callee, Span span,
                        std::vector<Argument>& arguments);
Ambient find_ambient(Checker& checker, const HostType& type, bool all = false);
hir::Expr* ambient_value(Checker& checker, const HostType& type, Span callee);

// Whether a parameter gets the name of the declared variable: in `motor left = motors.small()` the
// library function gets "left".
bool names_result(const Parameter& parameter, const Type* type, const Type* result) {
  return parameter.name == "name" && type->is(Kind::kText) && result->is(Kind::kHost) &&
         result->host->is_handle;
}

// `plot(x, y)`: an absent text parameter `xUnit: unit(x)?` gets the SI unit of x, from its type.
std::optional<std::string> unit_for(const Signature& signature, const Parameter& parameter,
                                    const Bindings& bindings, TypePool& types) {
  if (parameter.unit_of.empty() || parameter.each_number) return std::nullopt;
  const int of = signature.index_of(parameter.unit_of);
  const Type* measured = instantiate(signature.parameters[of].type, bindings, types);
  while (measured != nullptr && measured->is(Kind::kList)) measured = measured->element;
  if (measured == nullptr || !measured->is_quantity()) return std::string();
  return si_unit(measured->dim);
}

// The expression for an absent text parameter `yUnits: units(y)?`, whose text follows when all functions are
// known (number_dims.hpp); null if it is no such parameter.
hir::Expr* units_text(Checker& checker, const Signature& signature, const Parameter& parameter,
                      const Type* type, Span callee, std::span<hir::Expr* const> values) {
  if (!parameter.each_number) return nullptr;
  const int of = signature.index_of(parameter.unit_of);
  const hir::Expr* value = values[static_cast<std::size_t>(of)];
  if (value == nullptr) return nullptr;
  auto* text = checker.make<hir::TextExpr>(hir::ExprKind::kText, type, callee, std::string_view());
  checker.shared.postponed.add(Postponed::Units{text, value});
  return text;
}

// The type of a parameter in this call, as far as it is known.
const Type* type_of(const Parameter& parameter, const Bindings& bindings, TypePool& types) {
  const Type* type = instantiate(parameter.type, bindings, types);
  return type != nullptr ? type : types.any();
}

}  // namespace

hir::Expr* call_native(Checker& checker, std::string_view name,
                       std::span<const NativeFunction* const> candidates, Span callee, Span span,
                       std::vector<Argument> arguments) {
  if (candidates.empty()) return unknown_name(checker, name, callee);
  for (const Argument& argument : arguments) {
    if (!argument.waits() && argument.value->type->is(Kind::kAny))
      return guessed_call(checker, name, candidates, callee, span, arguments);
  }
  if (hir::Expr* told = explained_call(checker, name, arguments, span)) return told;
  settle_start(checker, candidates, arguments);
  Fit best;
  const NativeFunction* function = choose(checker, name, candidates, callee, span, arguments, best);
  if (function == nullptr) return guessed_call(checker, name, candidates, callee, span, arguments);
  const bool starts_whole = name == "fold" && arguments.size() > 1 && !arguments[1].waits() &&
                            arguments[1].value->type->is(Kind::kInt);
  const Span before =
      checker.surroundings.set_start_of_fold(starts_whole ? arguments[1].value->span : Span{});
  hir::Expr* out = finish_native(checker, name, *function, callee, span, arguments, best);
  checker.surroundings.set_start_of_fold(before);
  return out;
}

namespace {

// Whether the argument is a lambda with a declared type of its parameter `i`.
bool is_written_with_type(const ast::Expr& written, std::size_t i) {
  return written.kind == ast::ExprKind::kLambda &&
         written.as<ast::LambdaExpr>().params[i].type != nullptr;
}

// Checks a lambda or the name of a function, after the other arguments have determined its type as
// far as possible.
hir::Expr* waiting_argument(Checker& checker, std::string_view name, const Argument& argument,
                            const TypePattern& pattern, Bindings& bindings) {
  const Type* expected = instantiate(pattern, bindings, checker.types);
  if (expected == nullptr && pattern.form == TypePattern::Form::kFunction) {
    // The result type is inferred from the body.
    std::vector<const Type*> parameters;
    for (std::size_t i = 0; i + 1 < pattern.parts.size(); ++i) {
      parameters.push_back(instantiate(pattern.parts[i], bindings, checker.types));
      // A declared type replaces one that is not known.
      const bool may_be_open = checker.shared.guesses || is_written_with_type(*argument.written, i);
      if (parameters.back() == nullptr && may_be_open) parameters.back() = checker.types.any();
    }
    if (std::ranges::find(parameters, nullptr) == parameters.end()) {
      expected = checker.types.function(std::move(parameters), checker.types.any());
    }
  }
  hir::Expr* value = checker.check(*argument.written, expected);
  if (match(pattern, value->type, false, bindings) < 0) {
    const std::string name_of_it = pattern_name(pattern, bindings, checker.types);
    std::string need = std::string(article(name_of_it)) + ' ' + name_of_it;
    std::string have = type_phrase(value->type);
    if (value->type->is(Kind::kFunction) && value->type->result->is(Kind::kVoid)) {
      need = "a function that gives a value";
      have = "one that gives none";
    }
    checker.report(make_diagnostic("E0313", value->span, {std::string(name), need, have}));
    return checker.failed(value->span);
  }
  return value;
}

// The arguments of a variadic parameter.
std::vector<hir::Expr*> rest_of(Checker& checker, const Parameter& parameter,
                                const std::vector<Argument>& arguments,
                                const std::vector<int>& rest, const Target& element) {
  std::vector<hir::Expr*> items;
  for (const int at : rest) {
    hir::Expr* item = arguments[at].value;
    if (parameter.any_number && item->type->is_quantity()) {
      item = checker.make<hir::ConvertExpr>(hir::ExprKind::kConvert, checker.types.real(),
                                            item->span, hir::Conversion::kSame, item);
    }
    items.push_back(checker.require(item, element));
  }
  return items;
}

// For editors: notes the selected function, and its named parameters.
void note_native_names(Checker& checker, const NativeFunction& function, Span callee,
                       const std::vector<Argument>& arguments, const Fit& fit) {
  if (checker.shared.learnt == nullptr || function.event != BlockEvent::kNone) return;
  checker.shared.learnt->native({callee, &function});
  for (std::size_t p = 0; p < fit.from.size(); ++p) {
    if (fit.from[p] < 0) continue;
    const Argument& argument = arguments[static_cast<std::size_t>(fit.from[p])];
    if (!argument.name.empty())
      checker.shared.learnt->native({argument.name_span, &function, static_cast<int>(p)});
  }
}

// A call that cannot be checked, for editors: names of settings, the contents of lambdas, and the
// type that the call would have.
hir::Expr* guessed_call(Checker& checker, std::string_view name,
                        std::span<const NativeFunction* const> candidates, Span callee, Span span,
                        std::vector<Argument>& arguments) {
  if (!checker.shared.guesses) return checker.failed(span);
  Begun begun = choose_begun(checker, candidates, arguments);
  const Signature* signature =
      begun.function != nullptr ? &checker.shared.signatures.of(*begun.function) : nullptr;
  if (signature != nullptr)
    note_native_names(checker, *begun.function, callee, arguments, begun.fit);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    Argument& argument = arguments[i];
    if (!argument.waits()) continue;
    const auto place = std::ranges::find(begun.fit.from, static_cast<int>(i));
    if (place == begun.fit.from.end()) continue;
    const auto p = static_cast<std::size_t>(place - begun.fit.from.begin());
    argument.value = waiting_argument(checker, name, argument, signature->parameters[p].type,
                                      begun.fit.bindings);
    if (begun.result == nullptr)
      begun.result = instantiate(signature->result, begun.fit.bindings, checker.types);
  }
  return checker.guessed(span, begun.result);
}

// The value of an absent text parameter that follows from the call: the name of the declared
// variable, or a unit.
std::optional<std::string> text_for(Checker& checker, const Signature& signature,
                                    const Parameter& parameter, const Type* type, const Fit& fit,
                                    const Type* result, Span span) {
  if (names_result(parameter, type, result) && checker.surroundings.is_named(span))
    return std::string(checker.surroundings.name_for(span));
  return unit_for(signature, parameter, fit.bindings, checker.types);
}

// The type of the result; null after a message. `columns` are those of a table that is read from a
// file.
const Type* native_result(Checker& checker, std::string_view name, const Signature& signature,
                          const Fit& fit, const std::vector<Argument>& arguments, Span span,
                          std::string& columns) {
  if (signature.result.form == TypePattern::Form::kTable)
    return loaded_table(checker, signature, fit, arguments, span, columns);
  const Type* result = instantiate(signature.result, fit.bindings, checker.types);
  if (result == nullptr)
    checker.report(make_diagnostic("E0323", span, {"the result of `" + std::string(name) + "`"}));
  return result;
}

hir::Expr* finish_native(Checker& checker, std::string_view name, const NativeFunction& function,
                         Span callee, Span span, std::vector<Argument>& arguments, Fit& fit) {
  const Signature& signature = checker.shared.signatures.of(function);
  const auto& parameters = signature.parameters;
  note_native_names(checker, function, callee, arguments, fit);
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const int from = fit.from[p];
    if (from < 0 || !arguments[from].waits()) continue;
    arguments[from].value =
        waiting_argument(checker, name, arguments[from], parameters[p].type, fit.bindings);
    if (arguments[from].value->type->is(Kind::kAny))
      return checker.guessed(span, instantiate(signature.result, fit.bindings, checker.types));
  }
  std::string columns;
  const Type* result = native_result(checker, name, signature, fit, arguments, span, columns);
  if (result == nullptr) return checker.failed(span);
  std::vector<hir::Expr*> values(parameters.size(), nullptr);
  std::vector<Span> spans(parameters.size(), Span{callee.end, callee.end, callee.source});
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    const Parameter& parameter = parameters[p];
    const Type* type = type_of(parameter, fit.bindings, checker.types);
    const int from = fit.from[p];
    if (p == 0 && fit.ambient) {
      values[p] = ambient_value(checker, *type->host, callee);
      if (values[p]->type->is(Kind::kAny)) return checker.guessed(span, result);
    } else if (from >= 0) {
      spans[p] = arguments[from].value->span;
      if (!arguments[from].name.empty()) spans[p] = cover(arguments[from].name_span, spans[p]);
      values[p] = checker.require(
          arguments[from].value, {.role = Target::Role::kArgument, .type = type, .function = name});
    } else if (parameter.variadic) {
      const auto items =
          rest_of(checker, parameter, arguments, fit.rest,
                  {.role = Target::Role::kArgument, .type = type->element, .function = name});
      if (!items.empty()) spans[p] = cover(items.front()->span, items.back()->span);
      values[p] = checker.make<hir::ListExpr>(hir::ExprKind::kList, type, span, checker.seq(items));
    } else if (parameter.default_value) {
      values[p] = literal_of(checker, *parameter.default_value, type, callee);
    } else if (const auto text =
                   !columns.empty() && parameter.name == "columns"
                       ? std::optional(columns)
                       : text_for(checker, signature, parameter, type, fit, result, span)) {
      values[p] = checker.make<hir::TextExpr>(hir::ExprKind::kText, type, callee,
                                              checker.arena.copy(*text));
    } else if (hir::Expr* units = units_text(checker, signature, parameter, type, callee, values)) {
      values[p] = units;
    } else {
      values[p] = checker.make<hir::AbsentExpr>(hir::ExprKind::kAbsent, type, callee);
    }
  }
  if (function.pauses) note_pause(checker, span);
  auto* call = checker.make<hir::CallNativeExpr>(hir::ExprKind::kCallNative, result, span,
                                                 &function, checker.seq(values),
                                                 hir::CallSite{span, callee, checker.seq(spans)});
  if (hir::Expr* loop = over_list(checker, function, *call)) return loop;
  if (!function.starts) note_callbacks(checker, function, values);
  return run_rule(checker, name, arguments, fit, call);
}

}  // namespace

// A pause in a condition would stop the clock that the condition depends on.
void note_pause(Checker& checker, Span span) {
  checker.scopes.use().pauses = true;
  for (const FunctionContext* context = &checker.scopes.here(); context != nullptr;
       context = context->outer) {
    if (context->kind != FunctionContext::Kind::kCondition) continue;
    report_pause(checker, *context->function, span);
    return;
  }
}

// ---- the first argument that is not written ----------------------------------------------------

namespace {

// Adds the ambient values of earlier entries that are not declared again.
void add_earlier(Checker& checker, const HostType& type, Ambient& out, bool all) {
  const KeptNames* kept = checker.shared.earlier.kept();
  if (kept == nullptr) return;
  Checker& main = *checker.shared.files.back();
  for (const KeptAmbient& ambient : *kept->ambient) {
    if (ambient.type != type.name || (!all && out.names.size() > 1)) continue;
    Checker& file = ambient.file != nullptr ? checker.shared.earlier.file(*ambient.file) : main;
    if (!file.names.declaration_of(ambient.name).empty() && &file == &main &&
        file.names.find_variable(ambient.name) != nullptr)
      continue;
    FunctionContext* where = nullptr;
    Local* local = file.scopes.find_top(ambient.name, where);
    if (local == nullptr) continue;
    out.local = local;
    out.where = where;
    out.names.push_back(ambient.name);
  }
}

Ambient find_ambient(Checker& checker, const HostType& type, bool all) {
  Ambient out;
  for (FunctionContext* context = &checker.scopes.here(); context != nullptr;
       context = context->outer) {
    for (auto with = context->ambients.rbegin(); with != context->ambients.rend(); ++with) {
      if (with->type == &type) return {&with->local, context, {with->local.variable->name}};
    }
  }
  const auto look_in = [&](FunctionContext& context, std::size_t count) {
    for (const std::size_t place : context.ambient_places) {
      if (place >= count || (!all && out.names.size() > 1)) return;
      Local& local = context.locals[place];
      if (local.variable->type->host != &type) continue;
      out.local = &local;
      out.where = &context;
      out.names.push_back(local.variable->name);
    }
  };
  for (FunctionContext* context = &checker.scopes.here();
       context != nullptr && context != &checker.scopes.main() && out.names.empty();
       context = context->outer) {
    look_in(*context, context->locals.size());
  }
  if (!out.names.empty()) return out;
  std::vector<std::string_view> found;
  for (Checker* file : checker.shared.files) {
    FunctionContext& top = file->scopes.main();
    const bool whole = &checker.scopes.here().root() == &top || top.blocks.size() < 2;
    look_in(top, whole ? top.locals.size() : top.blocks[1]);
    for (const std::string_view declared : file->names.ambient(type.name)) {
      if (!all && out.names.size() > 2) break;  // two of them differ
      out.names.push_back(declared);
    }
    std::ranges::sort(out.names);
    out.names.erase(std::unique(out.names.begin(), out.names.end()), out.names.end());
    // Two files may use the same name.
    std::ranges::move(out.names, std::back_inserter(found));
    out.names.clear();
    if (!all && found.size() > 1) break;
  }
  out.names = std::move(found);
  add_earlier(checker, type, out, all);
  return out;
}

std::string plural_of(const HostType& type) {
  return type.resource != nullptr ? std::string(type.resource->plural)
                                  : "values of type " + std::string(type.name);
}

hir::Expr* ambient_value(Checker& checker, const HostType& type, Span callee) {
  const Ambient found = find_ambient(checker, type, checker.messages.takes_errors());
  if (found.names.size() > 1) {
    static constexpr std::array<std::string_view, 8> kCounts = {"",     "",     "two", "three",
                                                                "four", "five", "six", "seven"};
    const std::size_t n = found.names.size();
    const ResourceWords* words = type.resource;
    Diagnostic diagnostic = make_diagnostic(
        "E0205", callee,
        {n < kCounts.size() ? std::string(kCounts[n]) : std::to_string(n), plural_of(type),
         words != nullptr ? "should " + std::string(words->act) : "is meant"});
    for (std::size_t i = 0; i < n; ++i) {
      diagnostic.why += (i == 0      ? ""
                         : i + 1 < n ? ", "
                                     : " and ") +
                        ('`' + std::string(found.names[i]) + '`');
    }
    diagnostic.why +=
        n == 2 ? " are both declared in this program" : " are declared in this program";
    const std::string first(found.names[0]);
    diagnostic.fix =
        Fix{.text = "write " + first + '.' + checker.text_of(callee) + "(...), or put " +
                    std::string(words != nullptr ? words->acts : "the calls") + " inside with (" +
                    std::string(type.name) + ": " + first + ") { ... }",
            .edits = {{{callee.begin, callee.begin, callee.source}, first + '.'}}};
    checker.report(std::move(diagnostic));
    return checker.failed(callee);
  }
  if (found.local != nullptr) return read(checker, *found.local, *found.where, callee);
  if (!found.names.empty()) return unknown_name(checker, found.names[0], callee);
  const auto suppliers = checker.registry.functions(std::string(type.name) + "()");
  if (!suppliers.empty()) return call_native(checker, type.name, suppliers, callee, callee, {});
  checker.report(make_diagnostic("E0220", callee, {std::string(type.name)}));
  return checker.failed(callee);
}

}  // namespace

const Fact* ambient_fact(Checker& checker, std::string_view name) {
  const HostType* type = checker.registry.type(name);
  if (type == nullptr) return nullptr;
  const Ambient found = find_ambient(checker, *type);
  if (found.names.size() > 1) return nullptr;
  if (found.local != nullptr) {
    const hir::Expr* init = found.local->variable->init;
    return init != nullptr ? fact_of(*init) : nullptr;
  }
  const auto suppliers = checker.registry.functions(std::string(name) + "()");
  if (!found.names.empty() || suppliers.empty()) return nullptr;
  return fact_of(*call_native(checker, name, suppliers, Span{}, Span{}, {}));
}

}  // namespace armlet::lang
