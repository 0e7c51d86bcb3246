#pragma once
// Values of fields as texts for users.

#include <string>

#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet {

// A number of a field, given in SI, in the unit of the field: "80 mm".
[[nodiscard]] std::string number_text(double si, const LabRow& field);
// A value given to a field: "80 mm", "true", "a text".
[[nodiscard]] std::string field_text(const Value& value);

}  // namespace armlet
