#pragma once
// Signatures of native functions: read from text once per program, matched against the types of a
// call.
//
// Pure functions over types; nothing here knows the syntax tree. T and U stand for any type, S for
// any struct, D and E for any quantity or double.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// A type that may contain variables.
struct TypePattern {
  enum class Form : std::uint8_t {
    kType,
    kVariable,
    kDimension,
    kList,
    kFunction,
    kTable,
    kRecord
  };
  Form form = Form::kType;
  const Type* type = nullptr;  // kType
  int variable = 0;            // kVariable: 0 is T and S, 1 is U
  bool is_struct = false;      // kVariable: S
  Dim dim{};                   // kDimension: dim * D^d * E^e
  int d = 0;
  int e = 0;
  // kList: the element; kFunction: parameters, then the result; kRecord: the fields.
  std::vector<TypePattern> parts{};
  std::vector<TypePattern> of{};     // kRecord: what stands in its name, OdeEvent<S>
  std::vector<std::string> names{};  // kRecord: its own, then those of its fields
};

struct Parameter {
  std::string name;
  TypePattern type;
  bool optional = false;    // `time?`: may be absent
  bool variadic = false;    // `number...`: the rest, as one list
  bool any_number = false;  // `number`: a double or any quantity, taken as SI
  std::optional<Constant> default_value{};

  [[nodiscard]] bool may_be_left_out() const { return optional || variadic || default_value; }
};

struct Signature {
  std::vector<Parameter> parameters;
  TypePattern result;

  [[nodiscard]] int index_of(std::string_view name) const;  // -1 if absent
};

// Finds host types and records of the library by name; null if there is none.
using TypeNames = std::function<const Type*(std::string_view)>;

// Reads "(x: D^2, n: int = 3) -> D". Without "->" the result is void. Empty with the reason in
// `error`.
[[nodiscard]] std::optional<Signature> parse_signature(std::string_view text, TypePool& types,
                                                       const TypeNames& names, std::string& error);
// Reads "reached: bool, time: time", the fields of a library record.
[[nodiscard]] std::optional<std::vector<RecordField>> parse_fields(std::string_view text,
                                                                   TypePool& types,
                                                                   const TypeNames& names,
                                                                   std::string& error);

// What the variables of a signature stand for in one call.
struct Bindings {
  const Type* types[2] = {nullptr, nullptr};
  std::optional<Dim> dims[2];
};

// How many of the conversions that happen by themselves (section 5) lead from one type to another:
// 0 if they are the same, 1 otherwise; -1 if none does. zero: the value is the literal 0 or 0.0,
// which is any quantity.
[[nodiscard]] int conversion_cost(const Type* from, const Type* to, bool zero = false);

// The dimension of a sum of quantities a and b under the angle rule of section 6; empty if they
// cannot be added.
[[nodiscard]] std::optional<Dim> common_dimension(Dim a, Dim b);

// Fits a type to a pattern, binding variables. Returns the cost as above, or -1.
[[nodiscard]] int match(const TypePattern& pattern, const Type* actual, bool zero,
                        Bindings& bindings);

// Whether every variable of the pattern is bound.
[[nodiscard]] bool is_bound(const TypePattern& pattern, const Bindings& bindings);
// The type that the pattern stands for; null if a variable is not bound (or a dimension cannot be
// represented).
[[nodiscard]] const Type* instantiate(const TypePattern& pattern, const Bindings& bindings,
                                      TypePool& types);
// As in the signature, with bound variables filled in: for messages.
[[nodiscard]] std::string pattern_name(const TypePattern& pattern, const Bindings& bindings,
                                       TypePool& types);

}  // namespace armlet::lang
