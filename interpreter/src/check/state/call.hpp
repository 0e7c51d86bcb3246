#pragma once
// The data of one call during overload resolution.

#include <string_view>
#include <vector>

#include "check/scopes/scope.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

// The use of a value. It selects the message for a value of the wrong type.
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

// string(x), which is part of the language.
inline constexpr std::string_view kToText = "string";

// A value, and the bracket after it on another line.
struct Joined {
  Span value;
  Span bracket;  // empty: on the same line
};

// One argument of a call. Lambdas and names of functions are checked later, when the type of their
// parameter is known.
struct Argument {
  std::string_view name{};  // empty: by position
  Span name_span{};
  const ast::Expr* written = nullptr;
  hir::Expr* value = nullptr;  // null: checked later
  [[nodiscard]] Span span() const { return value != nullptr ? value->span : written->span; }
  [[nodiscard]] bool waits() const { return value == nullptr; }
};

// The assignment of the arguments of a call to the parameters of one function.
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
  int argument = -1;  // the one that does not fit
  int parameter = -1;
  int matched = 0;  // count of arguments that fit, to find the most similar function
  int cost = 0;
  int generic = 0;
  int zero_quantities = 0;     // literal zeros taken as quantities
  bool ambient = false;        // the first parameter is the ambient value of the program
  bool asks_function = false;  // for a lambda with another count of parameters
  std::vector<int> from;       // by parameter: index of the argument, -1 none
  std::vector<int> rest;       // arguments of the variadic parameter
  Bindings bindings;
};

// The ambient values of the program that a call at one position may refer to.
struct Ambient {
  Local* local = nullptr;  // the only one, if it is declared above
  FunctionContext* where = nullptr;
  std::vector<std::string_view> names;  // sorted
};

// Whether == compares the contents of values of this type.
[[nodiscard]] bool has_deep_equality(const Type* type);

// Whether the value is the literal 0 or 0.0, which fits any quantity.
[[nodiscard]] bool is_zero(const hir::Expr& value);

}  // namespace armlet::lang
