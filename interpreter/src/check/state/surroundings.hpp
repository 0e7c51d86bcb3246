#pragma once
// The context of the expression that is checked, for messages and default values.

#include <string>
#include <string_view>
#include <utility>

#include "armlet/interpreter/source.hpp"

namespace armlet::lang {

class Surroundings {
 public:
  // Sets the declaration whose first value is being checked.
  void set_named(std::string_view name, Span value) {
    name_ = name;
    value_ = value;
  }
  // The name of the declared variable if the value is its first value; otherwise empty.
  [[nodiscard]] std::string_view name_for(Span value) const {
    return is_named(value) ? name_ : std::string_view();
  }
  [[nodiscard]] bool is_named(Span value) const { return value_ == value; }

  // Whether it is the value of a classic declaration, int a = ...; set_classic returns the previous
  // setting.
  [[nodiscard]] bool is_classic() const { return classic_; }
  bool set_classic(bool classic) { return std::exchange(classic_, classic); }

  // The int literal with which a `fold` starts, while its function is checked; otherwise empty.
  [[nodiscard]] Span start_of_fold() const { return start_of_fold_; }
  Span set_start_of_fold(Span start) { return std::exchange(start_of_fold_, start); }

  // Whether it is an argument of a named row of a block. Its lambda is called repeatedly and reads
  // the current values of variables. set_in_row returns the previous setting.
  bool set_in_row(bool in_row) { return std::exchange(in_row_, in_row); }

  // The likely type of a lambda's parameter without a declared type.
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
