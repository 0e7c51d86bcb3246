#include "vocabulary/signature.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/basic_types.hpp"

namespace armlet::lang {
namespace {

using Form = TypePattern::Form;

// Parses one signature from left to right, and keeps the first error.
class SignatureReader {
 public:
  SignatureReader(std::string_view text, TypePool& types, const TypeNames& names)
      : text_(text), types_(types), names_(names) {}

  std::optional<Signature> signature() {
    Signature out;
    out.result.type = types_.void_type();
    expect("(");
    while (ok() && !accept(")")) {
      out.parameters.push_back(parameter());
      if (!accept(",")) {
        expect(")");
        break;
      }
    }
    if (accept("->")) out.result = type();
    skip();
    if (ok() && at_ < text_.size()) fail("more text than a signature has");
    for (const Parameter& parameter : out.parameters) {
      if (!parameter.unit_of.empty() && out.index_of(parameter.unit_of) < 0)
        fail("`" + parameter.name + "` is the unit of `" + parameter.unit_of +
             "`, which is no parameter,");
    }
    if (!ok()) return std::nullopt;
    return out;
  }

  std::optional<std::vector<RecordField>> fields() {
    std::vector<RecordField> out;
    skip();
    while (ok() && at_ < text_.size()) {
      const std::string name(word());
      expect(":");
      const TypePattern pattern = type();
      if (ok() && !is_bound(pattern, {})) fail("a field has a variable type");
      if (!ok()) break;
      out.push_back({.name = name, .type = instantiate(pattern, {}, types_)});
      if (!accept(",")) break;
    }
    skip();
    if (ok() && at_ < text_.size()) fail("more text than fields");
    if (!ok()) return std::nullopt;
    return out;
  }

  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  [[nodiscard]] bool ok() const { return error_.empty(); }

  void fail(std::string_view what) {
    if (ok()) error_ = std::string(what) + " at column " + std::to_string(at_ + 1);
  }

  void skip() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool accept(std::string_view mark) {
    skip();
    if (!text_.substr(at_).starts_with(mark)) return false;
    at_ += mark.size();
    return true;
  }

  void expect(std::string_view mark) {
    if (!accept(mark)) fail("`" + std::string(mark) + "` is missing");
  }

  template <class Predicate>
  std::string_view take(Predicate predicate) {
    const std::size_t begin = at_;
    while (at_ < text_.size() && predicate(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::string_view word() {
    skip();
    const std::string_view out =
        take([](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '.'; });
    if (out.empty()) fail("a name is missing");
    return out;
  }

  Parameter parameter() {
    Parameter out;
    out.name = word();
    expect(":");
    skip();
    if (text_.substr(at_).starts_with("number...")) {
      at_ += 9;
      out.variadic = out.any_number = true;
      out.type = list_of({.type = types_.real()});
      return out;
    }
    out.type = accept_unit(out) ? TypePattern{.type = types_.text()} : type();
    if (accept("...")) {
      out.variadic = true;
      out.type = list_of(std::move(out.type));
    } else if (accept("?")) {
      out.optional = true;
    } else if (accept("=")) {
      out.default_value = fitting_literal(out);
    }
    return out;
  }

  // unit(x), units(x)
  bool accept_unit(Parameter& parameter) {
    parameter.each_number = accept("units(");
    if (!parameter.each_number && !accept("unit(")) return false;
    parameter.unit_of = word();
    expect(")");
    return true;
  }

  static TypePattern list_of(TypePattern element) {
    TypePattern out{.form = Form::kList};
    out.parts.push_back(std::move(element));
    return out;
  }

  TypePattern type() {
    TypePattern left = factor();
    for (;;) {
      const bool times = accept("*");
      if (!times && !accept("/")) return left;
      left = product(left, factor(), times ? 1 : -1);
    }
  }

  // A type with a dimension in the general form dim * D^d * E^e.
  TypePattern as_dimension(const TypePattern& pattern) {
    if (pattern.form == Form::kDimension) return pattern;
    if (pattern.form != Form::kType || pattern.type == nullptr || !pattern.type->is(Kind::kReal)) {
      fail("only quantities can be multiplied");
      return {.form = Form::kDimension};
    }
    return {.form = Form::kDimension, .dim = pattern.type->dim};
  }

  TypePattern simplified(TypePattern pattern) {
    if (pattern.form != Form::kDimension || pattern.d != 0 || pattern.e != 0) return pattern;
    return {.type = types_.quantity(pattern.dim)};
  }

  TypePattern product(const TypePattern& a, const TypePattern& b, int sign) {
    TypePattern out = as_dimension(a);
    const TypePattern right = as_dimension(b);
    const auto dim = sign > 0 ? multiply(out.dim, right.dim) : divide(out.dim, right.dim);
    if (!dim) fail("an exponent is too large");
    out.dim = dim.value_or(Dim{});
    out.d += sign * right.d;
    out.e += sign * right.e;
    return simplified(out);
  }

  TypePattern factor() {
    TypePattern out = base();
    while (ok() && accept("[")) out = accept("]") ? list_of(std::move(out)) : map_of(out);
    if (!accept("^")) return out;
    const int sign = accept("-") ? -1 : 1;
    const std::string_view digits = take([](unsigned char c) { return std::isdigit(c) != 0; });
    if (digits.size() != 1) {
      fail("an exponent of one digit is missing");
      return out;
    }
    const int n = sign * (digits[0] - '0');
    out = as_dimension(out);
    const auto dim = power(out.dim, 2 * n);
    out.dim = dim.value_or(Dim{});
    out.d *= n;
    out.e *= n;
    return simplified(out);
  }

  // A map type such as int[string] or double[][int], from the `[` on.
  TypePattern map_of(const TypePattern& element) {
    const std::size_t begin = at_;
    const TypePattern key = type();
    expect("]");
    const Type* values = instantiate(element, {}, types_);
    const bool is_key =
        key.type != nullptr &&
        (key.type->is(Kind::kText) || key.type->is(Kind::kInt) || key.type->is(Kind::kAny));
    if (ok() && (!is_key || values == nullptr || values->is(Kind::kVoid))) {
      at_ = begin;
      fail(is_key ? "the values of a map have no variable type" : "keys are texts or ints");
    }
    return {.type = ok() ? types_.map(key.type, values) : types_.any()};
  }

  TypePattern base() {
    if (accept("(")) {
      TypePattern out = type();
      expect(")");
      return out;
    }
    const std::string_view name = word();
    if (name == "T" || name == "U" || name == "S")
      return {.form = Form::kVariable, .variable = name == "U", .is_struct = name == "S"};
    if (name == "D") return {.form = Form::kDimension, .d = 1};
    if (name == "E") return {.form = Form::kDimension, .e = 1};
    if (name == "fn") return function();
    if (name == "table") return {.form = Form::kTable};
    if (accept("<")) {
      TypePattern of = type();
      expect(">");
      expect("{");
      TypePattern out = record(name);
      out.of.push_back(std::move(of));
      return out;
    }
    if (accept("{")) return record(name);
    return {.type = named(name)};
  }

  TypePattern function() {
    TypePattern out{.form = Form::kFunction};
    expect("(");
    while (ok() && !accept(")")) {
      out.parts.push_back(type());
      if (!accept(",")) {
        expect(")");
        break;
      }
    }
    if (accept("->")) {
      out.parts.push_back(type());
    } else {
      out.parts.push_back({.type = types_.void_type()});
    }
    return out;
  }

  TypePattern record(std::string_view name) {
    TypePattern out{.form = Form::kRecord, .names = {std::string(name)}};
    do {
      out.names.emplace_back(word());
      expect(":");
      out.parts.push_back(type());
    } while (ok() && accept(","));
    expect("}");
    return out;
  }

  const Type* named(std::string_view name) {
    if (const Type* type = basic_type(types_, name)) return type;
    if (name == "void") return types_.void_type();
    // Dimensions have priority, because a record `force` of the library would hide the dimension.
    if (const auto dim = dimension_named(name)) return types_.quantity(*dim);
    if (const Type* type = names_(name)) return type;
    fail("`" + std::string(name) + "` is not a type");
    return types_.any();
  }

  struct Literal {
    Constant value;
    const Type* type;
  };

  // The default value of a parameter, converted to its type.
  Constant fitting_literal(const Parameter& parameter) {
    skip();
    const std::size_t begin = at_;
    Literal written = literal();
    const bool is_zero = written.type->dim.is_none() && written.value.real == 0.0 &&
                         (written.type->is(Kind::kInt) || written.type->is(Kind::kReal));
    Bindings bindings;
    if (ok() && match(parameter.type, written.type, is_zero, bindings) < 0) {
      at_ = begin;
      fail("the default of `" + parameter.name + "` is " + type_phrase(written.type) + ", not " +
           pattern_name(parameter.type, {}, types_) + ',');
    }
    return std::move(written.value);
  }

  Literal literal() {
    skip();
    if (accept("true")) return {{.kind = Constant::Kind::kBool, .truth = true}, types_.boolean()};
    if (accept("false")) return {{.kind = Constant::Kind::kBool}, types_.boolean()};
    if (accept("\"")) {
      const std::string_view text = take([](unsigned char c) { return c != '"'; });
      expect("\"");
      return {{.kind = Constant::Kind::kText, .text = std::string(text)}, types_.text()};
    }
    return number();
  }

  Literal number() {
    const double sign = accept("-") ? -1.0 : 1.0;
    const std::string_view digits =
        take([](unsigned char c) { return c != ',' && c != ')' && c != ' '; });
    if (const auto quantity = parse_quantity(digits)) {
      return {{.kind = Constant::Kind::kReal, .real = sign * quantity->si},
              types_.quantity(quantity->dim)};
    }
    const auto value = parse_number(digits);
    if (!value) {
      fail("the default is not a literal");
      return {{}, types_.integer()};
    }
    const bool whole = std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    if (!whole) return {{.kind = Constant::Kind::kReal, .real = sign * *value}, types_.real()};
    return {{.integer = static_cast<std::int64_t>(sign * *value), .real = sign * *value},
            types_.integer()};
  }

  std::string_view text_;
  TypePool& types_;
  const TypeNames& names_;
  std::size_t at_ = 0;
  std::string error_;
};

}  // namespace

int Signature::index_of(std::string_view name) const {
  const auto found = std::ranges::find(parameters, name, &Parameter::name);
  return found == parameters.end() ? -1 : static_cast<int>(found - parameters.begin());
}

std::optional<Signature> parse_signature(std::string_view text, TypePool& types,
                                         const TypeNames& names, std::string& error) {
  SignatureReader reader(text, types, names);
  auto out = reader.signature();
  error = reader.error();
  return out;
}

std::optional<std::vector<RecordField>> parse_fields(std::string_view text, TypePool& types,
                                                     const TypeNames& names, std::string& error) {
  SignatureReader reader(text, types, names);
  auto out = reader.fields();
  error = reader.error();
  return out;
}

}  // namespace armlet::lang
