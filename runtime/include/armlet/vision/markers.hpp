#pragma once
// Square markers with a number, by OpenCV (opencv.hpp).

#include <Eigen/Core>
#include <array>
#include <vector>

#include "armlet/image/image.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// A marker found in a picture.
//
// corners  px, of its black square: upper left, upper right, lower right and lower left of the
//          marker when it stands upright.
struct FoundMarker {
  int id = 0;
  Eigen::Matrix<double, 4, 2> corners = Eigen::Matrix<double, 4, 2>::Zero();
};

// The markers of a picture in the order of their numbers, with corners refined to fractions of a
// pixel. A marker needs a light border around its black square.
//
// grey        one channel of 8 bits.
// dictionary  index into kMarkerDictionaries (image/parameters.hpp).
// throws      ArgumentError for another kind of picture, more than 2,097,152 pixels, a dictionary
//             that does not exist, and where there is no OpenCV.
// source      S. Garrido-Jurado and others, Automatic generation and detection of highly reliable
//             fiducial markers under occlusion, Pattern Recognition 47, 2014.
std::vector<FoundMarker> find_markers(const Image& grey, int dictionary);

// The picture of a marker: its black square with the code, and one cell of white around it.
//
// cell    px of a side of a cell, 1 to 200.
// throws  ArgumentError for a number that the dictionary does not have, and as find_markers.
Image marker_picture(int id, int dictionary, int cell);

// The corners of a marker in its own frame, in the order of FoundMarker: x to the right, y upwards,
// z out of the marker, the origin in its centre.
//
// size    m, of a side of the black square.
// throws  ArgumentError for a size that is not above 0.
Eigen::Matrix<double, 4, 3> marker_points(double size);

}  // namespace armlet
