#pragma once
// The functions of pictures and their parameters as data, for code that offers, explains or sets
// them. The functions check their arguments against this table.

#include <array>
#include <span>
#include <string_view>

namespace armlet {

// Values of `method` of corners, in the order of CornerMethod.
inline constexpr std::array<std::string_view, 3> kCornerMethods{"susan", "harris", "fast"};
// Values of `dictionary` of markers: cells of the code and number of markers. Those with 5 x 5
// cells and 1024 markers are ArUco's, with 6 x 6 and 587 AprilTag's.
inline constexpr std::array<std::string_view, 5> kMarkerDictionaries{"4x4_50", "5x5_100", "6x6_250",
                                                                     "aruco", "apriltag_36h11"};

// The values of a parameter: any number in the range, an integer in it, or one of the names in
// `choices`.
enum class ParameterKind { kNumber, kWhole, kChoice };

// A parameter of a function of pictures.
//
// name           as it is written in a program.
// least, most    the range, both included; for a choice the first and the last index.
// default_value  for a choice an index.
// unit           "px", "grey levels", "rad"; empty for a plain number.
// sentence       its meaning.
// choices        the names that a choice has; empty for numbers.
struct PictureParameter {
  std::string_view name;
  ParameterKind kind;
  double least;
  double most;
  double default_value;
  std::string_view unit;
  std::string_view sentence;
  std::span<const std::string_view> choices{};
};

// A function of pictures: what it returns, in one sentence, and its parameters in order.
struct PictureFunction {
  std::string_view name;
  std::string_view sentence;
  std::span<const PictureParameter> parameters;
};

// All functions, in alphabetical order.
std::span<const PictureFunction> picture_functions();

// The function of that name, or null.
const PictureFunction* find_picture_function(std::string_view name);

// The parameter of that name.
//
// throws  ArgumentError with the nearest name if there is no such function or parameter.
const PictureParameter& picture_parameter(std::string_view function, std::string_view parameter);

// throws  ArgumentError with the value, the range and the unit unless the range of the table holds
//         the value (and the value is whole where whole numbers are expected).
void check_picture_parameter(std::string_view function, std::string_view parameter, double value);
// The same for a function that is not in the table; the message names its parameter.
void check_picture_parameter_as(std::string_view shown_function, std::string_view shown_parameter,
                                const PictureParameter& range, double value);

}  // namespace armlet
