#pragma once
// Values of fields as people read them.

#include <string>

#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet {

// A number of a field, SI, in the field's own unit: "80 mm".
[[nodiscard]] std::string number_text(double si, const LabRow& field);
// A value that somebody gives a field: "80 mm", "true", "a text".
[[nodiscard]] std::string field_text(const Value& value);

}  // namespace armlet
