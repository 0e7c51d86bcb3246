#include "armlet/image/parameters.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <set>

#include "armlet/core/error.hpp"
#include "refusal_of.hpp"

using namespace armlet;

TEST_CASE("every default lies in its range and both ends of every range are taken") {
  std::string_view last;
  for (const PictureFunction& function : picture_functions()) {
    CHECK(last < function.name);
    last = function.name;
    CHECK(function.sentence.back() == '.');
    std::set<std::string_view> names;
    for (const PictureParameter& parameter : function.parameters) {
      CAPTURE(parameter.name);
      CHECK(names.insert(parameter.name).second);
      CHECK(parameter.sentence.back() == '.');
      const auto check = [&](double value) {
        check_picture_parameter(function.name, parameter.name, value);
      };
      CHECK_NOTHROW(check(parameter.default_value));
      CHECK_NOTHROW(check(parameter.least));
      CHECK_NOTHROW(check(parameter.most));
      CHECK_THROWS_AS(check(parameter.least - 1), ArgumentError);
      CHECK_THROWS_AS(check(std::nextafter(parameter.most, 1e300)), ArgumentError);
      CHECK_THROWS_AS(check(std::nan("")), ArgumentError);
      CHECK_THROWS_AS(check(std::numeric_limits<double>::infinity()), ArgumentError);
      if (parameter.kind == ParameterKind::kWhole)
        CHECK_THROWS_AS(check(parameter.least + 0.5), ArgumentError);
      if (parameter.kind == ParameterKind::kChoice)
        CHECK(parameter.choices.size() == static_cast<std::size_t>(parameter.most) + 1);
    }
  }
}

TEST_CASE("messages say the value, the range, the unit and the nearest name") {
  CHECK(refusal_of([] { check_picture_parameter("corners", "threshold", 300); }) ==
        "`threshold` of `corners` is 300; expected a whole number from 1 to 255 grey levels.");
  CHECK(refusal_of([] { check_picture_parameter("corners", "method", 3); }) ==
        "`method` of `corners` is 3; expected one of susan, harris, fast.");
  CHECK(refusal_of([] { picture_parameter("corners", "treshold"); }) ==
        "The parameter of `corners` `treshold` does not exist; the nearest name is `threshold`.");
  CHECK(refusal_of([] { picture_parameter("zzzz", "sigma"); }) ==
        "The function of pictures `zzzz` does not exist; the names are adaptiveThreshold, "
        "blobs, blur, boxBlur, circles, closing, contours, corners, dilate, edges, erode, "
        "flow, grey, lines, markerPicture, markers, match, noise, opening, polygon, "
        "refineCorners, scale, threshold.");
  CHECK(find_picture_function("zzzz") == nullptr);
}
