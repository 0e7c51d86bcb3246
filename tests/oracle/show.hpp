#pragma once
// Values as text (language reference, sections 3.2 and 8.7), written without a look at the code of
// the virtual machine.

#include <string>

#include "armlet/interpreter/type.hpp"
#include "value.hpp"

namespace armlet::oracle {

// {x:.2f mm}: digits -1, style 0 and unit "" where nothing is written.
struct Style {
  int digits = -1;
  char letter = 0;
  std::string unit;
  double factor = 1.0;  // SI value of one unit
  char align = 0;
  bool sign = false;
  bool zeros = false;
  int width = 0;

  [[nodiscard]] bool has_digits() const { return digits >= 0 || letter != 0; }
};

// A double as print shows it: "2.0", "0.1", "1e-07".
[[nodiscard]] std::string show_number(double value);
[[nodiscard]] std::string show(const Value& value, const Type& type, const Style& style = {});

}  // namespace armlet::oracle
