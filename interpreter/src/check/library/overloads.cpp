#include "check/library/overloads.hpp"

#include <algorithm>
#include <tuple>

#include "check/functions/function_names.hpp"
#include "check/library/misfits.hpp"
#include "check/state/checker.hpp"
#include "check/types/any_table.hpp"

namespace armlet::lang {
namespace {

using Problem = Fit::Problem;

bool is_ambient_first(const Signature& signature) {
  if (signature.parameters.empty()) return false;
  const TypePattern& first = signature.parameters[0].type;
  return first.form == TypePattern::Form::kType && first.type->is(Kind::kHost) &&
         first.type->host->is_ambient;
}

bool is_ambient(const Type& type) { return type.is(Kind::kHost) && type.host->is_ambient; }

// Finds parameters by name; with a table if there are many parameters and arguments.
class ParameterNames {
 public:
  ParameterNames(const Signature& signature, std::size_t searches) : signature_(signature) {
    constexpr std::size_t kMany = 16;
    if (signature.parameters.size() < kMany || searches < kMany) return;
    for (std::size_t i = 0; i < signature.parameters.size(); ++i)
      table_.emplace(signature.parameters[i].name, static_cast<int>(i));
  }

  [[nodiscard]] int find(std::string_view name) const {
    if (table_.empty()) return signature_.index_of(name);
    const auto found = table_.find(name);
    return found == table_.end() ? -1 : found->second;
  }

 private:
  const Signature& signature_;
  std::unordered_map<std::string_view, int> table_;
};

// Whether a call with this count of positional values can fit.
bool takes_values(const Signature& signature, std::size_t count) {
  const auto& parameters = signature.parameters;
  const std::size_t ambient = is_ambient_first(signature) ? 1 : 0;
  std::size_t needed = 0;
  for (const Parameter& parameter : parameters) needed += parameter.may_be_left_out() ? 0 : 1;
  const bool any_number = !parameters.empty() && parameters.back().variadic;
  return count + ambient >= needed && (any_number || count <= parameters.size());
}

auto rank(const Fit& fit) {
  return std::tuple(fit.cost, fit.generic, fit.ambient, fit.zero_quantities);
}

}  // namespace

// Assigns the arguments to parameters: by position, then by name.
bool place_arguments(const Signature& signature, const std::vector<Argument>& arguments, Fit& fit) {
  const auto& parameters = signature.parameters;
  const ParameterNames names(signature, arguments.size());
  fit.from.assign(parameters.size(), -1);
  std::size_t next = fit.ambient ? 1 : 0;
  bool named = false;
  const auto problem = [&fit](Problem what, int argument) {
    fit.problem = what;
    fit.argument = argument;
    return false;
  };
  for (int i = 0; i < static_cast<int>(arguments.size()); ++i) {
    const Argument& argument = arguments[i];
    if (!argument.name.empty()) {
      named = true;
      const int at = names.find(argument.name);
      if (at < (fit.ambient ? 1 : 0)) return problem(Problem::kUnknownName, i);
      if (fit.from[at] >= 0) return problem(Problem::kTwice, i);
      fit.from[at] = i;
      continue;
    }
    if (named) return problem(Problem::kAfterNamed, i);
    if (next >= parameters.size()) return problem(Problem::kTooMany, i);
    if (parameters[next].variadic) {
      fit.rest.push_back(i);
    } else {
      fit.from[next++] = i;
    }
  }
  for (std::size_t p = fit.ambient ? 1 : 0; p < parameters.size(); ++p) {
    if (fit.from[p] >= 0 || parameters[p].may_be_left_out()) continue;
    fit.parameter = static_cast<int>(p);
    return problem(Problem::kMissing, -1);
  }
  return true;
}

namespace {

// The cost of the declared parameter types of a function (null for those without a type) for a
// pattern: 0 if all are the same, 1 if one differs, 2 if one of the two is a struct. -1 if the
// pattern has a struct where no type is declared, unless the other arguments determine it.
int cost_of_parameters(const TypePattern& pattern, const std::vector<const Type*>& written,
                       const Bindings& known) {
  if (pattern.form != TypePattern::Form::kFunction) return 0;
  int cost = 0;
  for (std::size_t i = 0; i < written.size(); ++i) {
    const TypePattern& part = pattern.parts[i];
    Bindings bindings = known;
    if (written[i] != nullptr) {
      const bool is_other = written[i]->is(Kind::kRecord) != part.is_struct;
      if (match(part, written[i], false, bindings) != 0) cost = std::max(cost, is_other ? 2 : 1);
    } else if (part.is_struct && !is_bound(part, known)) {
      return -1;
    }
  }
  return cost;
}

// The cost of a lambda or the name of a function for a function type: it fits if it has as many
// parameters, and costs less if its declared types are those of the pattern. -1: it does not fit.
int fit_waiting(Checker& checker, const ast::Expr& written, const TypePattern& pattern,
                const Bindings& known) {
  std::size_t wanted = 0;
  if (pattern.form == TypePattern::Form::kFunction) {
    wanted = pattern.parts.size() - 1;
  } else if (pattern.form == TypePattern::Form::kType && pattern.type->is(Kind::kFunction)) {
    wanted = pattern.type->parameters.size();
  } else {
    return -1;
  }
  if (written.kind == ast::ExprKind::kLambda) {
    const auto& params = written.as<ast::LambdaExpr>().params;
    if (params.size() != wanted) return -1;
    std::vector<const Type*> types;
    for (const ast::Param& param : params) types.push_back(resolve_open(checker, param.type));
    return cost_of_parameters(pattern, types, known);
  }
  if (const std::string name = library_function(checker, written); !name.empty()) {
    const bool fits =
        name == kToText
            ? wanted == 1
            : std::ranges::any_of(
                  checker.registry.functions(name), [&](const NativeFunction* function) {
                    return takes_values(checker.shared.signatures.of(*function), wanted);
                  });
    return fits ? 0 : -1;
  }
  const FunctionDecl* function = written_function(checker, written);
  if (function == nullptr || function->node->params.size() != wanted) return -1;
  return cost_of_parameters(pattern, function->parameters, known);
}

void match_argument(Checker& checker, const Signature& signature,
                    const std::vector<Argument>& arguments, int argument, int parameter, Fit& fit) {
  const Parameter& target = signature.parameters[parameter];
  const Argument& given = arguments[argument];
  const TypePattern& pattern = target.variadic ? target.type.parts[0] : target.type;
  int cost = 0;
  if (given.waits()) {
    cost = fit_waiting(checker, *given.written, pattern, fit.bindings);
  } else if (target.any_number) {
    cost = given.value->type->is_number() ? 0 : -1;
  } else {
    cost = match(pattern, given.value->type, is_zero(*given.value), fit.bindings);
  }
  if (cost < 0) {
    if (fit.problem == Problem::kNone) {
      fit.problem = Problem::kType;
      fit.argument = argument;
      fit.parameter = parameter;
      fit.asks_function = given.waits() && pattern.form == TypePattern::Form::kFunction;
    }
    return;
  }
  ++fit.matched;
  const Type* type = pattern.form == TypePattern::Form::kType ? pattern.type : nullptr;
  if (!given.waits() && is_zero(*given.value) && type != nullptr && type->is_quantity())
    ++fit.zero_quantities;
  fit.cost += cost;
  if (pattern.form != TypePattern::Form::kType || target.variadic) ++fit.generic;
}

}  // namespace

Fit fit(Checker& checker, const Signature& signature, const std::vector<Argument>& arguments,
        bool ambient, bool begun) {
  Fit out;
  out.ambient = ambient;
  if (!place_arguments(signature, arguments, out)) {
    if (!begun || out.problem != Problem::kMissing) return out;
    out.problem = Problem::kNone;
  }
  // Zeros and lambdas get their types from the other arguments, so they are checked last.
  const auto pass_of = [&](int argument) {
    const Argument& given = arguments[argument];
    return given.waits() ? 2 : is_zero(*given.value) ? 1 : 0;
  };
  for (int pass = 0; pass < 3; ++pass) {
    for (int p = 0; p < static_cast<int>(out.from.size()); ++p) {
      const int from = out.from[p];
      if (from >= 0 && pass_of(from) == pass)
        match_argument(checker, signature, arguments, from, p, out);
      if (!signature.parameters[p].variadic) continue;
      for (const int rest : out.rest) {
        if (pass_of(rest) == pass) match_argument(checker, signature, arguments, rest, p, out);
      }
    }
  }
  return out;
}

Begun choose_begun(Checker& checker, std::span<const NativeFunction* const> candidates,
                   const std::vector<Argument>& arguments) {
  Begun out;
  bool agree = true;
  for (const NativeFunction* candidate : candidates) {
    const Signature& signature = checker.shared.signatures.of(*candidate);
    for (const bool ambient : {false, true}) {
      if (ambient && !is_ambient_first(signature)) continue;
      Fit attempt = fit(checker, signature, arguments, ambient, true);
      if (attempt.problem != Problem::kNone) continue;
      const Type* result = instantiate(signature.result, attempt.bindings, checker.types);
      agree = agree && (out.function == nullptr || result == out.result);
      if (out.function != nullptr && rank(attempt) >= rank(out.fit)) continue;
      out = {candidate, std::move(attempt), result};
    }
  }
  if (!agree) out.result = nullptr;
  return out;
}

const NativeFunction* choose(Checker& checker, std::string_view name,
                             std::span<const NativeFunction* const> candidates, Span callee,
                             Span span, const std::vector<Argument>& arguments, Fit& best) {
  const NativeFunction* chosen = nullptr;
  const NativeFunction* closest = nullptr;
  Fit closest_fit;
  std::vector<const NativeFunction*> equal;
  for (const NativeFunction* candidate : candidates) {
    const Signature& signature = checker.shared.signatures.of(*candidate);
    for (const bool ambient : {false, true}) {
      if (ambient && !is_ambient_first(signature)) continue;
      Fit attempt = fit(checker, signature, arguments, ambient);
      if (attempt.problem != Problem::kNone) {
        // f.g(): the name before the point is no argument of the call.
        const bool has_receiver = !arguments.empty() && arguments[0].written == nullptr &&
                                  !arguments[0].waits() && is_ambient(*arguments[0].value->type);
        const auto closeness = [&](const Fit& f) {
          return std::tuple(!has_receiver || !f.ambient, f.matched, f.problem == Problem::kType,
                            f.argument, f.asks_function);
        };
        if (closest == nullptr || closeness(attempt) > closeness(closest_fit) ||
            (closeness(attempt) == closeness(closest_fit) && attempt.ambient &&
             !closest_fit.ambient && candidate == closest)) {
          closest = candidate;
          closest_fit = std::move(attempt);
        }
        continue;
      }
      if (chosen != nullptr && rank(attempt) == rank(best)) equal.push_back(candidate);
      if (chosen != nullptr && rank(attempt) >= rank(best)) continue;
      chosen = candidate;
      best = std::move(attempt);
      equal.assign(1, candidate);
    }
  }
  if (chosen == nullptr && closest != nullptr) {
    report_misfit(checker, name, checker.shared.signatures.of(*closest), callee, span, arguments,
                  closest_fit);
  } else if (equal.size() > 1) {
    // sum([]): the type of the elements is needed.
    for (const Argument& argument : arguments) {
      const bool is_open = argument.value != nullptr && argument.value->type->is(Kind::kList) &&
                           argument.value->type->element->is(Kind::kAny);
      if (!is_open) continue;
      checker.report(make_diagnostic("E0323", argument.value->span, {"this empty list"}));
      return nullptr;
    }
    Diagnostic diagnostic = make_diagnostic("E0319", callee, {std::string(name)});
    for (const NativeFunction* candidate : equal) {
      diagnostic.why += (diagnostic.why.empty() ? "" : ", ") + std::string(name);
      diagnostic.why += candidate->signature;
    }
    checker.report(std::move(diagnostic));
    return nullptr;
  }
  return chosen;
}

}  // namespace armlet::lang
