#pragma once

#include <string>
#include <string_view>

// Errors in robot descriptions that the library does not report, or not with names. Each is a
// sentence without a full stop, and empty if there is none. Whether the text is XML is checked by
// the library.
namespace armlet {

// More links or joints than a mechanism may have, or the first link that is its own parent, has two
// parents or belongs to a circle: "link `fore` is its own parent (joint `elbow`)".
std::string structure_fault(std::string_view text);

// The first link or joint with a text that is not a number: "link `upper` has xyz=\"0 0 nan\" in
// its
// origin; expected finite numbers".
std::string number_fault(std::string_view text);

// The first element that only xacro files have; empty if there is none.
std::string xacro_fault(std::string_view text);

}  // namespace armlet
