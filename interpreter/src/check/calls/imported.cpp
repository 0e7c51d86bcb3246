#include "check/calls/imported.hpp"

#include "check/calls/calls.hpp"
#include "check/functions/functions.hpp"
#include "check/names/imports.hpp"
#include "check/names/reading.hpp"

namespace armlet::lang {

hir::Expr* imported_member(Checker& checker, const Import& from, const ast::MemberExpr& member,
                           const Type* expected) {
  const std::string_view name = member.member.text;
  if (from.file == nullptr) return checker.failed(member.span);
  Checker& file = *from.file;
  const std::string import = checker.text_of(member.object->span);
  if (refuse_member(checker, file, import, member.member)) return checker.failed(member.span);
  FunctionContext* where = nullptr;
  if (Local* local = file.scopes.find_top(name, where))
    return read(checker, *local, *where, member.span);
  if (FunctionDecl* function = file.names.find_function(name))
    return function_value(checker, *function, expected, member.span);
  if (file.names.find_type(name) != nullptr)
    checker.report(
        make_diagnostic("E0219", member.span, {import + '.' + std::string(name), "type"}));
  return checker.failed(member.span);  // its declaration failed, which was reported
}

hir::Expr* call_imported(Checker& checker, const Import& from, const ast::CallExpr& call,
                         const ast::MemberExpr& member) {
  const std::string_view name = member.member.text;
  const Span callee = member.member.span;
  if (from.file == nullptr) return checker.failed(call.span);
  Checker& file = *from.file;
  const std::string import = checker.text_of(member.object->span);
  if (refuse_member(checker, file, import, member.member)) return checker.failed(call.span);
  if (FunctionDecl* function = file.names.find_function(name)) {
    return call_script(checker, *function, callee, call.span,
                       arguments_of(checker, call.args, name));
  }
  const Type* const type = file.names.find_type(name);
  if (type != nullptr && type->is(Kind::kRecord)) {
    return construct(checker, *checker.shared.structs.find(type), callee, call.span,
                     arguments_of(checker, call.args, name));
  }
  return call_value(checker, imported_member(checker, from, member, nullptr), call);
}

}  // namespace armlet::lang
