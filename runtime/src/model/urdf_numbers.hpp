#pragma once

#include <string>
#include <string_view>

namespace armlet {

// The first link or joint of a robot description with a number that is none: "link `upper` has
// xyz=\"0 0 nan\" in its origin; expected finite numbers". Empty if there is none.
std::string number_fault(std::string_view text);

}  // namespace armlet
