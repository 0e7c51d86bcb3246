#pragma once
// Edges, and the lines and circles among them, by OpenCV (opencv.hpp). Ranges and defaults of
// options are those of image/parameters.hpp. All throw ArgumentError for another kind of picture,
// more than 4,194,304 pixels, an option out of range, and where there is no OpenCV.

#include <Eigen/Core>

#include "armlet/image/image.hpp"
#include "armlet/math/eigen_layout.hpp"

namespace armlet {

// 255 on edges one pixel wide, else 0.
//
// grey       one channel of 8 bits.
// low, high  grey levels: thresholds on the length of the gradient by Sobel's masks, which is 4 for
//            a slope of half a grey level per pixel. An edge begins where it is above high, and
//            continues as long as it is above low.
// source     J. Canny, A computational approach to edge detection, IEEE Trans. PAMI 8(6), 1986.
Image find_edges(const Image& grey, double low = 50.0, double high = 150.0);

// votes       least number of pixels of a line.
// min_length  px; shorter segments are left out.
// max_gap     px; pieces of a line with a smaller gap are one segment.
struct LineOptions {
  int votes = 40;
  double min_length = 30.0;
  double max_gap = 5.0;
};

// Segments in a picture of edges from the longest to the shortest, each with its ends x0, y0 and
// x1, y1 in px, fitted to the white pixels within two pixels by least squares.
//
// edges   pixels of 0 and 255, at most 50,000 of 255.
// source  J. Matas, C. Galambos, J. Kittler, Robust detection of lines using the progressive
//         probabilistic Hough transform, Computer Vision and Image Understanding 78, 2000.
Eigen::Matrix<double, Eigen::Dynamic, 4> find_lines(const Image& edges,
                                                    const LineOptions& options = {});

// min_radius, max_radius  px.
// distance   px; least distance between the centres of circles.
// edge       grey levels: the upper limit of find_edges; the lower one is half of it.
// roundness  0.5 to 1: how round a circle has to be (1: perfect).
struct CircleOptions {
  int min_radius = 5;
  int max_radius = 200;
  double distance = 20.0;
  double edge = 100.0;
  double roundness = 0.8;
};

// Circles from the best to the worst, each with its centre x, y and radius in px, fitted to the
// edges within 2.5 px by least squares.
//
// grey    one channel of 8 bits, with at most 30,000 pixels on edges.
// source  OpenCV, HOUGH_GRADIENT_ALT; C. Kimme, D. Ballard, J. Sklansky, Finding circles by an
//         array of accumulators, Communications of the ACM 18(2), 1975.
Eigen::Matrix<double, Eigen::Dynamic, 3> find_circles(const Image& grey,
                                                      const CircleOptions& options = {});

}  // namespace armlet
