#include <algorithm>

#include "vocabulary/signature.hpp"

namespace armlet::lang {
namespace {

using Form = TypePattern::Form;

int number_cost(const Type* from, const Type* to, bool zero) {
  if (from->is(Kind::kInt)) return to->dim.is_none() || zero ? 1 : -1;
  if (from->dim == to->dim) return 0;
  if (zero && from->is_double()) return 1;
  return from->dim.without_angle() == to->dim ? 1 : -1;
}

// D = (actual / dim)^(1/d), for the only variable without a value.
bool solve(const TypePattern& pattern, Dim actual, Bindings& bindings) {
  Dim known = pattern.dim;
  int unknown = -1;
  int exponent = 0;
  for (int i = 0; i < 2; ++i) {
    const int n = i == 0 ? pattern.d : pattern.e;
    if (n == 0) continue;
    if (!bindings.dims[i]) {
      if (unknown >= 0) return false;
      unknown = i;
      exponent = n;
      continue;
    }
    const auto factor = power(*bindings.dims[i], 2 * n);
    const auto product = factor ? multiply(known, *factor) : std::nullopt;
    if (!product) return false;
    known = *product;
  }
  if (unknown < 0 || 2 % exponent != 0) return false;
  const auto rest = divide(actual, known);
  const auto root = rest ? power(*rest, 2 / exponent) : std::nullopt;
  if (!root) return false;
  bindings.dims[unknown] = *root;
  return true;
}

std::optional<Dim> dimension_of(const TypePattern& pattern, const Bindings& bindings) {
  std::optional<Dim> out = pattern.dim;
  for (int i = 0; i < 2; ++i) {
    const int n = i == 0 ? pattern.d : pattern.e;
    if (n == 0) continue;
    if (!bindings.dims[i]) return std::nullopt;
    const auto factor = power(*bindings.dims[i], 2 * n);
    out = factor ? multiply(*out, *factor) : std::nullopt;
    if (!out) return std::nullopt;
  }
  return out;
}

int match_dimension(const TypePattern& pattern, const Type* actual, bool zero, Bindings& bindings) {
  if (!actual->is_number()) return -1;
  const int cost = actual->is(Kind::kInt) ? 1 : 0;
  if (!is_bound(pattern, bindings)) return solve(pattern, actual->dim, bindings) ? cost : -1;
  const std::optional<Dim> wanted = dimension_of(pattern, bindings);
  if (!wanted) return -1;
  if (zero || actual->dim == *wanted) return cost;
  const std::optional<Dim> common = common_dimension(actual->dim, *wanted);
  if (!common) return -1;
  // A plain D gets the common dimension of both.
  if (pattern.d == 1 && pattern.e == 0 && pattern.dim.is_none()) bindings.dims[0] = *common;
  if (pattern.e == 1 && pattern.d == 0 && pattern.dim.is_none()) bindings.dims[1] = *common;
  return 1;
}

// Matches a record type of a signature: same name, and matching fields.
int match_record(const TypePattern& pattern, const Type* actual, Bindings& bindings) {
  if (!actual->is(Kind::kRecord) || actual->is_table()) return -1;
  const RecordInfo& record = *actual->record;
  const std::string_view name = std::string_view(record.name).substr(0, record.name.find('<'));
  if (name != pattern.names[0] || record.fields.size() != pattern.parts.size()) return -1;
  for (std::size_t i = 0; i < pattern.parts.size(); ++i) {
    if (record.fields[i].name != pattern.names[i + 1] ||
        match(pattern.parts[i], record.fields[i].type, false, bindings) != 0)
      return -1;
  }
  return 0;
}

int match_function(const TypePattern& pattern, const Type* actual, Bindings& bindings) {
  if (!actual->is(Kind::kFunction) || actual->parameters.size() + 1 != pattern.parts.size()) {
    return -1;
  }
  for (std::size_t i = 0; i < actual->parameters.size(); ++i) {
    if (match(pattern.parts[i], actual->parameters[i], false, bindings) != 0) return -1;
  }
  return match(pattern.parts.back(), actual->result, false, bindings) == 0 ? 0 : -1;
}

}  // namespace

int conversion_cost(const Type* from, const Type* to, bool zero) {
  if (from == to || from->is(Kind::kAny) || to->is(Kind::kAny)) return 0;
  if (from->is_number() && to->is(Kind::kReal)) return number_cost(from, to, zero);
  if (from->is(Kind::kList) && to->is(Kind::kList)) {
    return conversion_cost(from->element, to->element);
  }
  if (from->is(Kind::kMap) && to->is(Kind::kMap)) {
    const bool is_open = from->key->is(Kind::kAny) || to->key->is(Kind::kAny);
    return is_open ? 0 : -1;
  }
  return from->is_table() && to->is_table() && from->record == to->record ? 0 : -1;
}

std::optional<Dim> common_dimension(Dim a, Dim b) {
  if (a == b) return a;
  if (a.without_angle() != b.without_angle() || a.is_only_angle()) return std::nullopt;
  return a.without_angle();
}

int match(const TypePattern& pattern, const Type* actual, bool zero, Bindings& bindings) {
  if (actual->is(Kind::kAny)) return 0;
  switch (pattern.form) {
    case Form::kType:
      return conversion_cost(actual, pattern.type, zero);
    case Form::kVariable: {
      const Type*& bound = bindings.types[pattern.variable];
      if (actual->is(Kind::kVoid)) return -1;
      if (pattern.is_struct && (!actual->is(Kind::kRecord) || actual->is_table())) return -1;
      if (bound != nullptr) return conversion_cost(actual, bound, zero);
      bound = actual;
      return 0;
    }
    case Form::kDimension:
      return match_dimension(pattern, actual, zero, bindings);
    case Form::kList:
      return actual->is(Kind::kList) ? match(pattern.parts[0], actual->element, false, bindings)
                                     : -1;
    case Form::kFunction:
      return match_function(pattern, actual, bindings);
    case Form::kTable:
      return actual->is_table() ? 0 : -1;
    case Form::kRecord:
      return match_record(pattern, actual, bindings);
  }
  return -1;
}

bool is_bound(const TypePattern& pattern, const Bindings& bindings) {
  if (pattern.form == Form::kVariable) return bindings.types[pattern.variable] != nullptr;
  if (pattern.form == Form::kDimension) {
    return (pattern.d == 0 || bindings.dims[0]) && (pattern.e == 0 || bindings.dims[1]);
  }
  return std::ranges::all_of(pattern.parts,
                             [&](const TypePattern& part) { return is_bound(part, bindings); });
}

const Type* instantiate(const TypePattern& pattern, const Bindings& bindings, TypePool& types) {
  switch (pattern.form) {
    case Form::kType:
      return pattern.type;
    case Form::kVariable:
      return bindings.types[pattern.variable];
    case Form::kDimension: {
      const std::optional<Dim> dim = dimension_of(pattern, bindings);
      return dim ? types.quantity(*dim) : nullptr;
    }
    case Form::kList: {
      const Type* element = instantiate(pattern.parts[0], bindings, types);
      return element != nullptr ? types.list(element) : nullptr;
    }
    case Form::kFunction: {
      std::vector<const Type*> parts;
      for (const TypePattern& part : pattern.parts) {
        parts.push_back(instantiate(part, bindings, types));
        if (parts.back() == nullptr) return nullptr;
      }
      const Type* result = parts.back();
      parts.pop_back();
      return types.function(std::move(parts), result);
    }
    case Form::kTable:
      return nullptr;  // one of many possible types
    case Form::kRecord: {
      std::vector<RecordField> fields;
      for (std::size_t i = 0; i < pattern.parts.size(); ++i) {
        fields.push_back({pattern.names[i + 1], instantiate(pattern.parts[i], bindings, types)});
        if (fields.back().type == nullptr) return nullptr;
      }
      std::string name = pattern.names[0];
      for (const TypePattern& of : pattern.of) {
        const Type* const type = instantiate(of, bindings, types);
        if (type == nullptr) return nullptr;
        name += '<' + type_name(type) + '>';
      }
      return types.record_of(name, std::move(fields));
    }
  }
  return nullptr;
}

std::string pattern_name(const TypePattern& pattern, const Bindings& bindings, TypePool& types) {
  if (pattern.form == Form::kTable) return "table";
  if (const Type* type = instantiate(pattern, bindings, types)) return type_name(type);
  if (pattern.form == Form::kDimension) return "number";
  if (pattern.form == Form::kList) return pattern_name(pattern.parts[0], bindings, types) + "[]";
  if (pattern.form == Form::kRecord) return pattern.names[0];
  if (pattern.form == Form::kFunction) {
    std::string text = "fn(";
    for (std::size_t i = 0; i + 1 < pattern.parts.size(); ++i)
      text += (i == 0 ? "" : ", ") + pattern_name(pattern.parts[i], bindings, types);
    return text + ") -> " + pattern_name(pattern.parts.back(), bindings, types);
  }
  return pattern.is_struct ? "struct" : "value";
}

}  // namespace armlet::lang
