#include "check/scopes/scopes.hpp"

#include "check/scopes/earlier.hpp"
#include "check/scopes/names.hpp"

namespace armlet::lang {

void Scopes::begin(hir::Function* program, Use& use) {
  main_.function = program;
  use_ = &use;
}

Local* Scopes::find(std::string_view name, FunctionContext*& where) {
  Local* local = find_here(name, where);
  return local != nullptr ? local : find_earlier(name, where);
}

Local* Scopes::find_top(std::string_view name, FunctionContext*& where) {
  where = &main_;
  Local* local = main_.find(name);
  return local != nullptr ? local : find_earlier(name, where);
}

// Inside functions a name refers to a variable that this file declares anywhere. In the text itself
// it does so only after the declaration.
Local* Scopes::find_earlier(std::string_view name, FunctionContext*& where) {
  if (names_ == nullptr) return nullptr;
  const KeptName* kept = names_->find_earlier(name);
  if (kept == nullptr || kept->variable == nullptr) return nullptr;
  if ((only_top_level_ || !in_program()) && names_->find_variable(name) != nullptr) return nullptr;
  where = &earlier_;
  if (Local* known = earlier_.find(name)) return known;
  earlier_.add({earlier_names_->variable(*kept), kept->how, kept->keyword, true});
  return &earlier_.locals.back();
}

Local* Scopes::find_here(std::string_view name, FunctionContext*& where) {
  if (!only_top_level_) {
    for (where = here_; where != nullptr; where = where->outer) {
      if (Local* local = where->find(name)) return local;
    }
    if (in_program()) return nullptr;
  }
  // Named functions and tests can use the variables that the top level has declared so far, but not
  // those of its inner blocks.
  where = &main_;
  Local* local = main_.find(name);
  const bool inner =
      local != nullptr && main_.blocks.size() > 1 && local >= main_.locals.data() + main_.blocks[1];
  return inner ? nullptr : local;
}

Local* Scopes::add(hir::Variable* variable, Declared how, Span keyword) {
  here_->add({.variable = variable, .how = how, .keyword = keyword});
  return &here_->locals.back();
}

std::size_t Scopes::close_block() {
  const std::size_t begin = here_->blocks.back();
  here_->blocks.pop_back();
  return begin;
}

void Scopes::forget(std::size_t first) {
  if (here_ != &main_ || !here_->blocks.empty()) here_->drop(first);
}

}  // namespace armlet::lang
