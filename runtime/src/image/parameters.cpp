#include "armlet/image/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "armlet/core/similar.hpp"

namespace armlet {
namespace {

constexpr ParameterKind kNumber = ParameterKind::kNumber;
constexpr ParameterKind kWhole = ParameterKind::kWhole;

constexpr std::string_view kGrey = "grey levels";
constexpr std::string_view kPixels = "px";

constexpr std::array<std::string_view, 2> kTouching{"sides", "corners"};
constexpr std::array<std::string_view, 2> kSwitch{"false", "true"};

constexpr std::array<PictureParameter, 3> kAdaptiveThreshold{{
    {"radius", kWhole, 1, 100, 10, kPixels,
     "The mean is that of a square with 2 radius + 1 pixels on each side."},
    {"offset", kNumber, -255, 255, 5, kGrey, "A pixel is white if it is above the mean less it."},
    {"gaussian", ParameterKind::kChoice, 0, 1, 0, "", "Whether the mean is weighted by a bell.",
     kSwitch},
}};

constexpr std::array<PictureParameter, 3> kBlobs{{
    {"minArea", kWhole, 1, 67'108'864, 20, kPixels, "Smaller regions are left out."},
    {"tolerance", kWhole, 0, 255, 40, kGrey,
     "A pixel has the colour if none of red, green and blue differs by more."},
    {"touching", ParameterKind::kChoice, 0, 1, 1, "",
     "Whether pixels of one region touch along sides only, or also at corners.", kTouching},
}};

constexpr std::array<PictureParameter, 1> kBlur{{
    {"sigma", kNumber, 0, 30, 1, kPixels, "Standard deviation of the Gaussian bell."},
}};

constexpr std::array<PictureParameter, 1> kBoxBlur{{
    {"radius", kWhole, 0, 100, 1, kPixels,
     "Each pixel becomes the mean of a square with 2 radius + 1 pixels on each side."},
}};

constexpr std::array<PictureParameter, 5> kCircles{{
    {"minRadius", kWhole, 1, 1000, 5, kPixels, "Smaller circles are left out."},
    {"maxRadius", kWhole, 1, 1000, 200, kPixels, "Larger circles are left out."},
    {"distance", kNumber, 5, 8192, 20, kPixels, "Centres of circles are at least so far apart."},
    {"edge", kNumber, 1, 1000, 100, kGrey, "The upper limit for gradients of edges."},
    {"roundness", kNumber, 0.5, 1, 0.8, "", "How round a circle has to be."},
}};

constexpr std::array<PictureParameter, 2> kContours{{
    {"holes", ParameterKind::kChoice, 0, 1, 0, "", "Whether outlines of holes are given.", kSwitch},
    {"minArea", kNumber, 0, 67'108'864, 0, kPixels, "Outlines around less are left out."},
}};

constexpr std::array<PictureParameter, 8> kCorners{{
    {"method", ParameterKind::kChoice, 0, 2, 0, "", "The detector.", kCornerMethods},
    {"threshold", kWhole, 1, 255, 20, kGrey,
     "susan and fast: pixels whose brightness differs by less count as alike."},
    {"quality", kNumber, 0, 1, 0.01, "",
     "harris: responses below this share of the strongest one are left out."},
    {"distance", kNumber, 0, 8192, 10, kPixels, "harris: corners are at least so far apart."},
    {"sensitivity", kNumber, 0, 0.25, 0.04, "", "harris: k in det(M) - k trace(M)^2."},
    {"max", kWhole, 0, 1'000'000, 0, "", "At most so many corners, the strongest ones; 0: all."},
    {"within", kNumber, 0, 8192, 20, kPixels,
     "How far a corner may be from the one that is looked for."},
    {"refine", ParameterKind::kChoice, 0, 1, 1, "",
     "Whether corners are refined to fractions of a pixel.", kSwitch},
}};

constexpr std::array<PictureParameter, 2> kEdges{{
    {"low", kNumber, 0, 1500, 50, kGrey, "An edge goes on while its gradient is above it."},
    {"high", kNumber, 0, 1500, 150, kGrey, "An edge begins where its gradient is above it."},
}};

constexpr std::array<PictureParameter, 3> kFlow{{
    {"window", kWhole, 5, 51, 21, kPixels, "Side of the square that is compared; odd."},
    {"levels", kWhole, 0, 8, 3, "", "How often the pictures are halved."},
    {"within", kNumber, 0, 8192, 0.5, kPixels,
     "How far a point is from its start on the way back."},
}};

constexpr std::array<PictureParameter, 3> kLines{{
    {"votes", kWhole, 10, 100'000, 40, kPixels, "A line has so many pixels at least."},
    {"minLength", kNumber, 0, 20'000, 30, kPixels, "Shorter segments are left out."},
    {"maxGap", kNumber, 0, 100, 5, kPixels, "Nearer pieces of a line are one segment."},
}};

constexpr PictureParameter kDictionary{"dictionary",          ParameterKind::kChoice, 0, 4, 0, "",
                                       "The set of markers.", kMarkerDictionaries};
constexpr std::array<PictureParameter, 3> kMarkerPicture{{
    {"id", kWhole, 0, 1023, 0, "", "The number of the marker."},
    kDictionary,
    {"cell", kWhole, 1, 200, 20, kPixels, "Side of a cell of the code."},
}};
constexpr std::array<PictureParameter, 1> kMarkers{{kDictionary}};

constexpr std::array<PictureParameter, 2> kMorphology{{
    {"radius", kWhole, 1, 50, 1, kPixels,
     "Of a square with 2 radius + 1 pixels on each side, or of a disc."},
    {"disc", ParameterKind::kChoice, 0, 1, 0, "", "Whether it is a disc.", kSwitch},
}};

constexpr std::array<PictureParameter, 2> kNoise{{
    {"sigma", kNumber, 0, 255, 5, kGrey, "Standard deviation of the Gaussian noise."},
    {"seed", kWhole, 0, 9'007'199'254'740'991, 1, "", "The same seed gives the same noise."},
}};

constexpr std::array<PictureParameter, 1> kPolygon{{
    {"tolerance", kNumber, 0, 8192, 2, kPixels, "How far the outline is from its polygon."},
}};

constexpr std::array<PictureParameter, 3> kRefineCorners{{
    {"window", kWhole, 1, 50, 5, kPixels,
     "Gradients are looked at in a square with 2 window + 1 pixels on each side."},
    {"iterations", kWhole, 1, 1000, 40, "", "At most so many steps for each corner."},
    {"precision", kNumber, 0, 1, 0.001, kPixels, "A shorter step is the last one."},
}};

constexpr std::array<PictureParameter, 1> kScale{{
    {"factor", kNumber, 0, 1'000'000, 1, "", "Brightness is multiplied by it and ends at 255."},
}};

constexpr std::array<PictureParameter, 1> kThreshold{{
    {"level", kWhole, 0, 255, 128, kGrey, "Brighter pixels become 255, all others 0."},
}};

constexpr std::array<PictureFunction, 23> kFunctions{{
    {"adaptiveThreshold", "A picture of black and white, for uneven light.", kAdaptiveThreshold},
    {"blobs", "Connected regions of a picture with their centres, areas and angles.", kBlobs},
    {"blur", "The picture smoothed by a Gaussian bell.", kBlur},
    {"boxBlur", "The picture smoothed by the mean of a square.", kBoxBlur},
    {"circles", "Circles with their centres and radii.", kCircles},
    {"closing", "The picture without small dark spots.", kMorphology},
    {"contours", "Outlines of regions.", kContours},
    {"corners", "Corners of a picture.", kCorners},
    {"dilate", "The picture with larger bright regions.", kMorphology},
    {"edges", "Edges in white on black.", kEdges},
    {"erode", "The picture with smaller bright regions.", kMorphology},
    {"flow", "Points followed from one picture to the next.", kFlow},
    {"grey", "The picture in shades of grey.", {}},
    {"lines", "Segments of straight lines with their ends.", kLines},
    {"markerPicture", "The picture of a marker.", kMarkerPicture},
    {"markers", "Square markers with their numbers and corners.", kMarkers},
    {"match", "Where a template fits best.", {}},
    {"noise", "The picture with Gaussian noise.", kNoise},
    {"opening", "The picture without small bright spots.", kMorphology},
    {"polygon", "The corners of an outline.", kPolygon},
    {"refineCorners", "Corners at fractions of a pixel.", kRefineCorners},
    {"scale", "The picture darker or brighter.", kScale},
    {"threshold", "A picture of black and white.", kThreshold},
}};

template <class Row>
[[noreturn]] void refuse_name(std::string_view what, std::string_view name,
                              std::span<const Row> rows) {
  std::vector<std::string_view> names;
  for (const Row& row : rows) names.push_back(row.name);
  const auto near = most_similar(name, names);
  throw ArgumentError(fmt::format("{} `{}` does not exist; {}.", what, name,
                                  near ? fmt::format("the nearest name is `{}`", *near)
                                       : fmt::format("the names are {}", fmt::join(names, ", "))));
}

std::string range_of(const PictureParameter& parameter) {
  if (parameter.kind == ParameterKind::kChoice)
    return fmt::format("one of {}", fmt::join(parameter.choices, ", "));
  return fmt::format("a {} from {} to {}", parameter.kind == kWhole ? "whole number" : "number",
                     parameter.least, parameter.most);
}

}  // namespace

std::span<const PictureFunction> picture_functions() { return kFunctions; }

const PictureFunction* find_picture_function(std::string_view name) {
  const auto found = std::find_if(kFunctions.begin(), kFunctions.end(),
                                  [&](const PictureFunction& f) { return f.name == name; });
  return found == kFunctions.end() ? nullptr : &*found;
}

const PictureParameter& picture_parameter(std::string_view function, std::string_view parameter) {
  const PictureFunction* row = find_picture_function(function);
  if (row == nullptr) refuse_name("The function of pictures", function, picture_functions());
  const auto found = std::find_if(row->parameters.begin(), row->parameters.end(),
                                  [&](const PictureParameter& p) { return p.name == parameter; });
  if (found == row->parameters.end())
    refuse_name(fmt::format("The parameter of `{}`", function), parameter, row->parameters);
  return *found;
}

void check_picture_parameter(std::string_view function, std::string_view parameter, double value) {
  check_picture_parameter_as(function, parameter, picture_parameter(function, parameter), value);
}

void check_picture_parameter_as(std::string_view function, std::string_view parameter,
                                const PictureParameter& row, double value) {
  const bool must_be_whole = row.kind != kNumber;
  // Comparisons with NaN are false, so NaN is refused too.
  if (value >= row.least && value <= row.most && (!must_be_whole || value == std::floor(value)))
    return;
  throw ArgumentError(fmt::format("`{}` of `{}` is {}; expected {}{}{}.", parameter, function,
                                  std::isnan(value) ? std::abs(value) : value, range_of(row),
                                  row.unit.empty() ? "" : " ", row.unit));
}

}  // namespace armlet
