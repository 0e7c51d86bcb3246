#include "program/unset.hpp"

#include <vector>

namespace armlet::lang {

namespace {

// Calls f for the types of the parts of a value of this type. Columns of tables are excluded,
// because they were read when the table was made, and so are captured values of functions, because
// the function checks them when it reads them.
template <class F>
void for_each_part(const Type& type, F f) {
  if (type.is(Kind::kList) || type.is(Kind::kMap)) f(type.element);
  if (!type.is(Kind::kRecord) || type.is_table()) return;
  for (const RecordField& field : type.record->fields) f(field.type);
}

}  // namespace

bool UnsetElements::may_be_in(const Type* type) {
  const bool is_none = !anything_ && (sets_ == nullptr || sets_->types.empty());
  if (is_none || !type->is_reference()) return false;
  auto& known = sets().known;
  if (const auto at = known.find(type); at != known.end()) return at->second;
  bool found = false;
  std::unordered_set<const Type*> reached{type};  // a struct may have lists of itself
  for (std::vector<const Type*> open{type}; !open.empty();) {
    const Type& next = *open.back();
    open.pop_back();
    found = found || (next.is(Kind::kList) && is_element(next.element));
    for_each_part(next, [&](const Type* part) {
      if (reached.insert(part).second) open.push_back(part);
    });
  }
  known[type] = found;
  for (const Type* part : reached) {
    if (found) (void)may_be_in(part);
  }
  return found;
}

}  // namespace armlet::lang
