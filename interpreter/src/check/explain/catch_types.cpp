#include "check/explain/catch_types.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace armlet::lang {
namespace {

// Whether a type catches every error, in this language or in another one.
bool takes_everything(std::string_view type) {
  constexpr std::array<std::string_view, 6> kAll = {
      "error", "Exception", "Throwable", "RuntimeException", "Error", "BaseException"};
  return std::ranges::find(kAll, type) != kAll.end();
}

// Whether a name is a kind of errors of the language, of the library or of the program, or a class
// that the program throws as in another language: `throw new Torn("belt")`.
bool is_kind(Checker& checker, const std::string& name) {
  if (name.empty() || checker.registry.messages().of_kind(name) != nullptr) return true;
  return std::ranges::any_of(checker.shared.files, [&](const Checker* file) {
    const std::uint32_t source = file->file.program.span.source;
    const std::string_view text = (*checker.into.sources)[source].text();
    return text.find('"' + name + '"') != std::string_view::npos ||
           text.find(name + '(') != std::string_view::npos;
  });
}

// The kind of errors for a type: "Timeout" for `Timeout` and `TimeoutException`; empty if there is
// none.
std::string kind_of(Checker& checker, const std::string& type) {
  if (is_kind(checker, type)) return type;
  for (const std::string_view ending : {"Exception", "Error"}) {
    if (!type.ends_with(ending)) continue;
    const std::string name = type.substr(0, type.size() - ending.size());
    if (!name.empty() && is_kind(checker, name)) return name;
  }
  return {};
}

}  // namespace

void advise_catch_of_a_type(Checker& checker, const ast::CatchClause& clause) {
  const std::string type(clause.type.text);
  if (type.empty() || takes_everything(type)) return;
  Diagnostic diagnostic = make_diagnostic("W0756", clause.type.span, {type});
  const std::string name(clause.name.text);
  const std::string kind = kind_of(checker, type);
  if (kind.empty()) {
    diagnostic.why = "there is no kind of errors called `" + type + '`';
    diagnostic.fix = Fix{.text = "write catch (" + name + ") and look at " + name + ".kind",
                         .edits = {{clause.head, name}},
                         .confidence = Confidence::kMaybe};
    return checker.report(std::move(diagnostic));
  }
  const std::string test = "if (" + name + ".kind != \"" + kind + "\") throw " + name;
  diagnostic.why = "kinds of errors are texts, and " + name + ".kind is that of this one";
  const Span body = clause.body->span;
  const Span start{body.begin + 1, body.begin + 1, body.source};
  const bool on_one_line =
      checker.line_of(body) == checker.line_of({body.end - 1, body.end, body.source});
  diagnostic.fix =
      Fix{.text = "write catch (" + name + ") { " + test + " ... }",
          .edits = {{clause.head, name}, {start, ' ' + test + (on_one_line ? ";" : "")}},
          .confidence = Confidence::kMaybe};
  checker.report(std::move(diagnostic));
}

}  // namespace armlet::lang
