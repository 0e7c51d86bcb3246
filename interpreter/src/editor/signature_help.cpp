// Help for the call around a position: its overloads and the current parameter.

#include <algorithm>

#include "editor/cursor.hpp"
#include "editor/facts.hpp"
#include "vocabulary/written_call.hpp"

namespace armlet {
namespace lang {
namespace {

using Overload = SignatureHelp::Overload;

// Finds the parameters in "name(a: T, b: U) -> V".
void find_parameters(Overload& out) {
  int depth = 0;
  std::uint32_t begin = 0;
  for (std::uint32_t i = 0; i < out.text.size(); ++i) {
    const char c = out.text[i];
    const bool opens = c == '(' || c == '[' || c == '{';
    const bool closes = c == ')' || c == ']' || c == '}';
    if (opens && ++depth == 1) begin = i + 1;
    if ((c == ',' && depth == 1) || (closes && depth == 1)) {
      if (i > begin) out.parameters.emplace_back(begin, i);
      begin = i + 2;
    }
    if (closes && --depth == 0) return;
  }
}

Span in_main(const Facts& facts, Span span) { return {span.begin, span.end, facts.main_source()}; }

std::optional<SignatureHelp> help_of_symbol(const Facts& facts, const OpenCall& call,
                                            const Symbol& symbol) {
  const std::span<const ast::Param> parameters =
      symbol.function != nullptr ? std::span<const ast::Param>(symbol.function->params)
                                 : std::span<const ast::Param>(symbol.structure->fields);
  Overload one{.text = std::string(symbol.name) + '(', .help = std::string(symbol.doc)};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (i > 0) one.text += ", ";
    const auto begin = static_cast<std::uint32_t>(one.text.size());
    one.text += facts.compiled.sources->slice(parameters[i].span);
    one.parameters.emplace_back(begin, static_cast<std::uint32_t>(one.text.size()));
  }
  one.text += ')';
  SignatureHelp out{.overloads = {std::move(one)}};
  const std::size_t at = static_cast<std::size_t>(call.values) + (call.behind_point ? 1 : 0);
  if (at < parameters.size() && call.setting.empty()) out.parameter = static_cast<int>(at);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!call.setting.empty() && parameters[i].name.text == call.setting)
      out.parameter = static_cast<int>(i);
  }
  return out;
}

}  // namespace

std::optional<SignatureHelp> signature_help(const Facts& facts, std::uint32_t at) {
  const Cursor cursor = cursor_at(facts, at);
  if (!cursor.call || cursor.call->kind == OpenCall::Kind::kBlock) return std::nullopt;
  const OpenCall& call = *cursor.call;
  const Symbol* symbol = callee_symbol(facts, call, at);
  if (symbol != nullptr && symbol->declared == in_main(facts, call.callee))
    return std::nullopt;  // the header of the function itself
  if (symbol != nullptr && (symbol->function != nullptr || symbol->structure != nullptr))
    return help_of_symbol(facts, call, *symbol);
  SignatureHelp out;
  const Learnt::NativeUse* chosen = facts.native_at(call.callee.begin);
  const std::vector<const NativeFunction*> all = candidates(facts, call);
  // Of each overload the function of its row that was chosen, or else the first.
  std::vector<const NativeFunction*> shown;
  for (const NativeFunction* function : all) {
    const NativeFunction& row = row_of(*function);
    if (shown.empty() || &row_of(*shown.back()) != &row) {
      Overload one{.text = std::string(row.name.substr(row.name.rfind('.') + 1)) +
                           std::string(row.signature),
                   .help = std::string(row.help)};
      find_parameters(one);
      out.overloads.push_back(std::move(one));
      shown.push_back(function);
    }
    if (chosen == nullptr || chosen->function != function) continue;
    out.active = out.overloads.size() - 1;
    shown.back() = function;
  }
  if (out.overloads.empty()) return std::nullopt;
  // The function that fits an incomplete call may have no parameter at the position.
  if (parameter_of(facts, call, *shown[out.active]) < 0) {
    const auto takes = [&](const NativeFunction* one) {
      return parameter_of(facts, call, *one) >= 0;
    };
    const auto first = std::ranges::find_if(shown, takes);
    if (first != shown.end()) out.active = static_cast<std::size_t>(first - shown.begin());
  }
  out.parameter = parameter_of(facts, call, *shown[out.active]);
  return out;
}

}  // namespace lang

std::optional<SignatureHelp> Analysis::signature_help(std::uint32_t at) const {
  if (facts_->signed_ == nullptr) return std::nullopt;
  const std::scoped_lock one_query(facts_->signed_->mutex);
  return lang::signature_help(*facts_, facts_->place(at));
}

}  // namespace armlet
