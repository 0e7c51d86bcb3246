// Edges, lines, circles, templates and corners of FAST.

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/opencv/room.hpp"

namespace armlet::room {
namespace {

// Largest number of edge pixels, so that a call ends in half a second whatever the options are.
constexpr int kMostForLines = 50'000;
constexpr int kMostForCircles = 30'000;

void limit_edge_pixels(const cv::Mat& edges, int most, const char* advice) {
  const int count = cv::countNonZero(edges);
  if (count <= most) return;
  throw Refused("it has " + std::to_string(count) + " pixels on edges, and at most " +
                std::to_string(most) + " are possible: " + advice);
}

// A segment fitted to the white pixels within two pixels of it, by least squares, with the
// projections of its ends.
cv::Vec4d fitted(const cv::Mat& edges, const cv::Vec4i& found) {
  const cv::Point2d from(found[0], found[1]), to(found[2], found[3]);
  const cv::Point2d along = to - from;
  const double length = std::hypot(along.x, along.y);
  const bool is_flat = std::abs(along.x) >= std::abs(along.y);
  const int steps = static_cast<int>(std::max(std::abs(along.x), std::abs(along.y)));
  std::vector<cv::Point2f> points;
  for (int i = 0; i <= steps; ++i) {
    const cv::Point2d at = from + along * (static_cast<double>(i) / std::max(1, steps));
    for (int side = -2; side <= 2; ++side) {
      const int x = static_cast<int>(std::lround(at.x)) + (is_flat ? 0 : side);
      const int y = static_cast<int>(std::lround(at.y)) + (is_flat ? side : 0);
      if (x < 0 || y < 0 || x >= edges.cols || y >= edges.rows || edges.at<std::uint8_t>(y, x) == 0)
        continue;
      points.emplace_back(static_cast<float>(x), static_cast<float>(y));
    }
  }
  if (points.size() < 3 || length < 2.0) return {from.x, from.y, to.x, to.y};
  cv::Vec4f line;
  cv::fitLine(points, line, cv::DIST_HUBER, 0, 0.001, 0.001);
  const cv::Point2d axis(line[0], line[1]), middle(line[2], line[3]);
  const cv::Point2d a = middle + axis * (from - middle).dot(axis);
  const cv::Point2d b = middle + axis * (to - middle).dot(axis);
  return {a.x, a.y, b.x, b.y};
}

// A circle fitted to the edge pixels near it, by least squares: x^2 + y^2 + D x + E y + F = 0 about
// its centre.
cv::Vec3d fitted(const std::vector<cv::Point>& edges, const cv::Vec3f& found) {
  constexpr double kNear = 2.5;  // px
  cv::Matx33d A = cv::Matx33d::zeros();
  cv::Vec3d b(0, 0, 0);
  int count = 0;
  for (const cv::Point& p : edges) {
    const double x = p.x - double{found[0]}, y = p.y - double{found[1]};
    if (std::abs(std::hypot(x, y) - found[2]) > kNear) continue;
    const cv::Vec3d row(x, y, 1.0);
    A += row * row.t();
    b -= row * (x * x + y * y);
    ++count;
  }
  const cv::Vec3d given(found[0], found[1], found[2]);
  cv::Vec3d s;
  if (count < 6 || !cv::solve(A, b, s, cv::DECOMP_CHOLESKY)) return given;
  const double square = 0.25 * (s[0] * s[0] + s[1] * s[1]) - s[2];
  const cv::Vec3d better(found[0] - 0.5 * s[0], found[1] - 0.5 * s[1],
                         square > 0.0 ? std::sqrt(square) : -1.0);
  return cv::norm(better - given) < 2.0 * kNear ? better : given;
}

// Position of the maximum of the parabola through three values at -1, 0 and 1, of which the middle
// one is the largest.
double peak(double before, double at, double after) {
  const double bend = before - 2.0 * at + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

}  // namespace

void edges(const DoorInput& input, const DoorResult& result) {
  cv::Mat found;
  cv::Canny(mat_of(input.picture), found, input.options[0], input.options[1], 3, true);
  give(result, found);
}

void lines(const DoorInput& input, const DoorResult& result) {
  const cv::Mat edges = mat_of(input.picture);
  limit_edge_pixels(edges, kMostForLines,
                    "take higher limits for edges(), or a part of the picture");
  std::vector<cv::Vec4i> found;
  cv::HoughLinesP(edges.clone(), found, 1.0, CV_PI / 180.0, static_cast<int>(input.options[0]),
                  input.options[1], input.options[2]);
  std::vector<cv::Vec4d> segments;
  for (const cv::Vec4i& each : found) segments.push_back(fitted(edges, each));
  const auto length = [](const cv::Vec4d& s) { return std::hypot(s[2] - s[0], s[3] - s[1]); };
  std::stable_sort(segments.begin(), segments.end(),
                   [&](const auto& a, const auto& b) { return length(a) > length(b); });
  std::vector<double> numbers;
  for (const cv::Vec4d& s : segments) numbers.insert(numbers.end(), s.val, s.val + 4);
  give(result, numbers);
}

void circles(const DoorInput& input, const DoorResult& result) {
  const cv::Mat picture = mat_of(input.picture);
  const double edge = input.options[3];
  cv::Mat edges;
  cv::Canny(picture, edges, 0.5 * edge, edge, 3, true);
  limit_edge_pixels(edges, kMostForCircles, "raise `edge`, blur() it, or take a part of it");
  std::vector<cv::Point> points;
  if (cv::countNonZero(edges) > 0) cv::findNonZero(edges, points);
  std::vector<cv::Vec3f> found;
  // Its gradients use Scharr's mask, which gives four times the values of Sobel's.
  cv::HoughCircles(picture, found, cv::HOUGH_GRADIENT_ALT, 1.5, input.options[2], 4.0 * edge,
                   input.options[4], static_cast<int>(input.options[0]),
                   static_cast<int>(input.options[1]));
  std::vector<double> numbers;
  for (const cv::Vec3f& each : found) {
    const cv::Vec3d circle = fitted(points, each);
    numbers.insert(numbers.end(), circle.val, circle.val + 3);
  }
  give(result, numbers);
}

void match(const DoorInput& input, const DoorResult& result) {
  cv::Mat scores;
  cv::matchTemplate(mat_of(input.picture), mat_of(input.other), scores, cv::TM_CCOEFF_NORMED);
  // A part of uniform brightness has no score.
  cv::patchNaNs(scores, -1.0);
  scores.setTo(-1.0, scores > 1.001F);
  double best = 0.0;
  cv::Point at;
  cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
  const auto score = [&](int x, int y) { return static_cast<double>(scores.at<float>(y, x)); };
  double x = at.x, y = at.y;
  if (at.x > 0 && at.x + 1 < scores.cols)
    x += peak(score(at.x - 1, at.y), best, score(at.x + 1, at.y));
  if (at.y > 0 && at.y + 1 < scores.rows)
    y += peak(score(at.x, at.y - 1), best, score(at.x, at.y + 1));
  give(result, std::vector<double>{x, y, std::clamp(best, -1.0, 1.0)});
}

void fast(const DoorInput& input, const DoorResult& result) {
  std::vector<cv::KeyPoint> found;
  cv::FAST(mat_of(input.picture), found, static_cast<int>(input.options[0]), true);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.response > b.response; });
  std::vector<double> numbers;
  for (const cv::KeyPoint& each : found) {
    numbers.push_back(each.pt.x);
    numbers.push_back(each.pt.y);
    numbers.push_back(each.response);
  }
  give(result, numbers);
}

}  // namespace armlet::room
