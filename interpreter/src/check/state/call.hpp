#pragma once
// What the checker knows about one call while it looks for the function that is meant.

#include <string_view>
#include <vector>

#include "check/scopes/scope.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

// What a value is needed for: decides the message when its type does not fit.
struct Target {
  enum class Role : std::uint8_t {
    kVariable,
    kArgument,
    kSetting,
    kResult,
    kElement
  } role = Role::kVariable;
  const Type* type = nullptr;
  std::string_view name{};      // of the variable or parameter
  std::string_view function{};  // kArgument, kSetting
  int position = 0;             // kArgument: from 1
  Span call{};                  // kArgument, kSetting
};

// string(x), which the language offers itself.
inline constexpr std::string_view kToText = "string";

// A value and the bracket that stands behind it on another line.
struct Joined {
  Span value;
  Span bracket;  // empty: on the same line
};

// One value handed to a call. Lambdas and names of functions wait for the type their parameter asks
// for.
struct Argument {
  std::string_view name{};  // empty: by position
  Span name_span{};
  const ast::Expr* written = nullptr;
  hir::Expr* value = nullptr;  // null: waits
  [[nodiscard]] Span span() const { return value != nullptr ? value->span : written->span; }
  [[nodiscard]] bool waits() const { return value == nullptr; }
};

// How the values of a call fall on the parameters of one function.
struct Fit {
  enum class Problem : std::uint8_t {
    kNone,
    kTooMany,
    kMissing,
    kUnknownName,
    kTwice,
    kType,
    kAfterNamed
  };
  Problem problem = Problem::kNone;
  int argument = -1;  // the one with the problem
  int parameter = -1;
  int matched = 0;  // values that fitted, to find the closest function
  int cost = 0;
  int generic = 0;
  int zero_quantities = 0;     // literal zeros taken as quantities
  bool ambient = false;        // the first parameter is the ambient value of the program
  bool asks_function = false;  // where a lambda with another number of values was given
  std::vector<int> from;       // per parameter: which argument, -1 none
  std::vector<int> rest;       // arguments of the variadic parameter
  Bindings bindings;
};

// The ambient values of the program that can be meant at one place.
struct Ambient {
  Local* local = nullptr;  // the only one, if it is declared above
  FunctionContext* where = nullptr;
  std::vector<std::string_view> names;  // sorted
};

// Whether == compares values of this type by their contents.
[[nodiscard]] bool has_deep_equality(const Type* type);

// The literal 0 or 0.0, which is any quantity.
[[nodiscard]] bool is_zero(const hir::Expr& value);

}  // namespace armlet::lang
