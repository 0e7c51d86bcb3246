#pragma once
// Signatures of native functions: parsed once per program, and matched with the types of a call.
//
// These are functions of types, independent of the syntax tree. T and U stand for any type, S for
// any struct, D and E for any quantity or double.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/type.hpp"

namespace armlet::lang {

// A type with variables.
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
  std::vector<TypePattern> of{};     // kRecord: the types in its name, OdeEvent<S>
  std::vector<std::string> names{};  // kRecord: its name, then those of its fields
};

struct Parameter {
  std::string name;
  TypePattern type;
  bool optional = false;    // `time?`: may be absent
  bool variadic = false;    // `number...`: the remaining arguments, as one list
  bool any_number = false;  // `number`: a double or any quantity, taken as SI
  std::optional<Constant> default_value{};
  std::string unit_of{};     // `unit(x)`: a text; if it is absent, the unit of x in SI
  bool each_number = false;  // `units(x)`: the units of the numbers in x, where its type has none

  [[nodiscard]] bool may_be_left_out() const { return optional || variadic || default_value; }
};

struct Signature {
  std::vector<Parameter> parameters;
  TypePattern result;

  [[nodiscard]] int index_of(std::string_view name) const;  // -1 if there is none
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

// The values of a signature's variables in one call.
struct Bindings {
  const Type* types[2] = {nullptr, nullptr};
  std::optional<Dim> dims[2];
};

// The cost of the implicit conversion (section 5) from one type to another: 0 if they are the same,
// 1 if there is a conversion, -1 if there is none. zero: the value is the literal 0 or 0.0, which
// fits any quantity.
[[nodiscard]] int conversion_cost(const Type* from, const Type* to, bool zero = false);

// The dimension of a sum of quantities a and b under the angle rule of section 6; empty if they
// cannot be added.
[[nodiscard]] std::optional<Dim> common_dimension(Dim a, Dim b);

// Matches a type with a pattern and sets its variables. Returns the cost as above, or -1.
[[nodiscard]] int match(const TypePattern& pattern, const Type* actual, bool zero,
                        Bindings& bindings);

// Whether every variable of the pattern has a value.
[[nodiscard]] bool is_bound(const TypePattern& pattern, const Bindings& bindings);
// The type of a pattern with the values of its variables; null if a variable has none, or if a
// dimension cannot be represented.
[[nodiscard]] const Type* instantiate(const TypePattern& pattern, const Bindings& bindings,
                                      TypePool& types);
// The text of the pattern in the signature, with the values of its variables, for messages.
[[nodiscard]] std::string pattern_name(const TypePattern& pattern, const Bindings& bindings,
                                       TypePool& types);

}  // namespace armlet::lang
