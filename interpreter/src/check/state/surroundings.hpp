#pragma once
// What stands around the expression that is checked, as far as messages and defaults depend on it.

#include <string>
#include <string_view>
#include <utility>

#include "armlet/interpreter/source.hpp"

namespace armlet::lang {

class Surroundings {
 public:
  // The declaration whose first value is being checked.
  void set_named(std::string_view name, Span value) {
    name_ = name;
    value_ = value;
  }
  // The name that a declaration gives to the value written there; empty: it is no first value.
  [[nodiscard]] std::string_view name_for(Span value) const {
    return is_named(value) ? name_ : std::string_view();
  }
  [[nodiscard]] bool is_named(Span value) const { return value_ == value; }

  // Whether it is the value of a classic declaration, int a = ...; set_classic gives what held.
  [[nodiscard]] bool is_classic() const { return classic_; }
  bool set_classic(bool classic) { return std::exchange(classic_, classic); }

  // The whole number with which a `fold` starts, while its function is checked; empty: none.
  [[nodiscard]] Span start_of_fold() const { return start_of_fold_; }
  Span set_start_of_fold(Span start) { return std::exchange(start_of_fold_, start); }

  // Whether it is an argument of a row of a block with names, which is asked again and again: its
  // lambda reads variables as they are then. set_in_row gives what held.
  bool set_in_row(bool in_row) { return std::exchange(in_row_, in_row); }

  // Of a lambda's parameter without a type.
  [[nodiscard]] const std::string& likely_type() const { return likely_type_; }
  std::string set_likely_type(std::string type) {
    return std::exchange(likely_type_, std::move(type));
  }

 private:
  std::string_view name_;
  Span value_{};
  bool classic_ = false;
  bool in_row_ = false;
  Span start_of_fold_{};
  std::string likely_type_ = "double";
};

}  // namespace armlet::lang
