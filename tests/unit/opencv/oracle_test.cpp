// Our own functions of pictures compared with those of OpenCV, over seeded random cases.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "armlet/camera/pinhole.hpp"
#include "armlet/core/random.hpp"
#include "armlet/image/blur.hpp"
#include "armlet/image/noise.hpp"
#include "armlet/vision/blobs.hpp"
#include "armlet/vision/harris.hpp"
#include "armlet/vision/homography.hpp"
#include "armlet/vision/planar_pose.hpp"
#include "armlet/vision/refine.hpp"

using namespace armlet;

namespace {

double random_between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

// About a normal deviate with deviation 1.
double bell(Random& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

cv::Mat mat_of(const Image& image) {
  return {image.height(), image.width(), CV_8UC1, const_cast<std::uint8_t*>(image.row(0))};
}

// Smoothed noise: texture with corners of all kinds.
Image texture(int width, int height, std::uint64_t seed, double sigma) {
  Image image(width, height, PixelKind::kGrey);
  for (int y = 0; y < height; ++y) std::fill_n(image.row(y), width, 128);
  Random random(seed);
  add_noise(image, 60.0, random);
  return gaussian_blurred(image, sigma);
}

// A wedge with a random corner, its smooth picture.
Image wedge(Random& random, Eigen::Vector2d& corner) {
  corner = {random_between(random, 28, 32), random_between(random, 28, 32)};
  const double turn = random_between(random, 0, 6.28), open = random_between(random, 1.2, 1.9);
  Image image(60, 60, PixelKind::kGrey);
  for (int y = 0; y < 60; ++y) {
    for (int x = 0; x < 60; ++x) {
      int inside = 0;
      for (int i = 0; i < 16; ++i) {
        const double dx = x + (i % 4 - 1.5) / 4 - corner.x(),
                     dy = y + (i / 4 - 1.5) / 4 - corner.y();
        const double angle = std::remainder(std::atan2(dy, dx) - turn, 6.283185307179586);
        inside += std::abs(angle) < 0.5 * open ? 1 : 0;
      }
      image.row(y)[x] = static_cast<std::uint8_t>(50 + 10 * inside);
    }
  }
  return gaussian_blurred(image, 0.7);
}

Eigen::Isometry3d random_view(Random& random) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translate(Eigen::Vector3d(random_between(random, -0.1, 0.1), random_between(random, -0.1, 0.1),
                              random_between(random, 0.5, 1.5)));
  const double angle = random_between(random, 0, 6.28);
  T.rotate(Eigen::AngleAxisd(random_between(random, 0.2, 1.0),
                             Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)));
  T.rotate(Eigen::AngleAxisd(random_between(random, -3, 3), Eigen::Vector3d::UnitZ()));
  return T;
}

}  // namespace

TEST_CASE("Harris: every corner is one of OpenCV's response, and none is missing") {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Image image = texture(120, 90, seed, 1.5);
    cv::Mat response;
    cv::cornerHarris(mat_of(image), response, 3, 3, 0.04);
    double strongest = 0.0;
    cv::minMaxLoc(response, nullptr, &strongest);
    const auto ours = harris_corners(image, {.quality = 0.02, .distance = 0.0});
    REQUIRE(ours.size() > 10);
    for (const HarrisCorner& c : ours) {
      CHECK(c.response == doctest::Approx(response.at<float>(c.y, c.x)).epsilon(1e-4));
    }
    std::size_t peaks = 0;
    for (int y = 1; y < 89; ++y) {
      for (int x = 1; x < 119; ++x) {
        const cv::Mat around = response(cv::Rect(x - 1, y - 1, 3, 3));
        double largest = 0.0;
        cv::minMaxLoc(around, nullptr, &largest);
        const double here = response.at<float>(y, x);
        if (here == largest && here > 0.0201 * strongest) ++peaks;
      }
    }
    CHECK(ours.size() >= peaks);
    CHECK(ours.size() <= peaks + 2);  // those between both limits
  }
}

TEST_CASE("refined corners are as near to the truth as those of cornerSubPix, and near to them") {
  Random random(21);
  double ours = 0.0, theirs = 0.0;
  constexpr int kCount = 200;
  for (int i = 0; i < kCount; ++i) {
    Eigen::Vector2d truth;
    const Image image = wedge(random, truth);
    PlanePoints start(1, 2);
    start << std::round(truth.x() + random_between(random, -1, 1)),
        std::round(truth.y() + random_between(random, -1, 1));
    const RefinedCorner found = refine_corners(image, start)[0];
    std::vector<cv::Point2f> points{
        {static_cast<float>(start(0, 0)), static_cast<float>(start(0, 1))}};
    cv::cornerSubPix(mat_of(image), points, {5, 5}, {-1, -1},
                     {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001});
    ours += (Eigen::Vector2d(found.x, found.y) - truth).squaredNorm();
    theirs += (Eigen::Vector2d(points[0].x, points[0].y) - truth).squaredNorm();
    CHECK(std::hypot(found.x - double{points[0].x}, found.y - double{points[0].y}) < 0.1);
  }
  MESSAGE("ours " << std::sqrt(ours / kCount) << " px, OpenCV's " << std::sqrt(theirs / kCount));
  CHECK(std::sqrt(ours / kCount) < std::sqrt(theirs / kCount) + 0.01);
}

TEST_CASE("regions have the areas, centres and moments of OpenCV's") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Image grey = texture(100, 80, seed, 2.5);
    Image mask(100, 80, PixelKind::kGrey);
    for (int y = 0; y < 80; ++y)
      for (int x = 0; x < 100; ++x) mask.row(y)[x] = grey.row(y)[x] > 135 ? 255 : 0;
    const auto ours = find_blobs(mask, mask, {.min_area = 1});
    cv::Mat labels, stats, centres;
    const int count = cv::connectedComponentsWithStats(mat_of(mask), labels, stats, centres, 8);
    REQUIRE(static_cast<int>(ours.size()) == count - 1);
    for (int k = 1; k < count; ++k) {
      // The two number regions in other orders.
      const Blob& blob =
          *std::min_element(ours.begin(), ours.end(), [&](const Blob& a, const Blob& b) {
            const auto off = [&](const Blob& each) {
              return std::hypot(each.x - centres.at<double>(k, 0),
                                each.y - centres.at<double>(k, 1)) +
                     std::abs(each.area - stats.at<int>(k, cv::CC_STAT_AREA));
            };
            return off(a) < off(b);
          });
      CHECK(blob.area == stats.at<int>(k, cv::CC_STAT_AREA));
      CHECK(std::abs(blob.x - centres.at<double>(k, 0)) < 1e-9);
      CHECK(std::abs(blob.y - centres.at<double>(k, 1)) < 1e-9);
      const cv::Moments m = cv::moments(labels == k, true);
      const double angle = 0.5 * std::atan2(2 * m.mu11, m.mu20 - m.mu02);
      if (std::hypot(2 * m.mu11, m.mu20 - m.mu02) > 1e-6 * (m.mu20 + m.mu02))
        CHECK(std::abs(std::sin(blob.angle - angle)) < 1e-6);
    }
  }
}

TEST_CASE("homographies of exact points equal those of OpenCV") {
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 4 + static_cast<int>(random.uniform() * 12);
    Eigen::Matrix3d H;
    H << 1, 0.1, 5, -0.1, 1, 7, 1e-3, 5e-4, 1;
    for (int i = 0; i < 6; ++i) H(i / 3, i % 3) += random_between(random, -0.2, 0.2);
    PlanePoints a(n, 2);
    for (int i = 0; i < n; ++i)
      a.row(i) << random_between(random, 0, 100) + 30 * (i % 2),
          random_between(random, 0, 100) + 30 * (i / 2 % 2);
    const PlanePoints b = map_points(H, a);
    std::vector<cv::Point2d> from, to;
    for (int i = 0; i < n; ++i) {
      from.emplace_back(a(i, 0), a(i, 1));
      to.emplace_back(b(i, 0), b(i, 1));
    }
    const auto ours = homography(a, b);
    const cv::Mat theirs = cv::findHomography(from, to);
    REQUIRE(ours.ok());
    if (theirs.empty()) continue;
    for (int i = 0; i < 9; ++i)
      CHECK((*ours)(i / 3, i % 3) ==
            doctest::Approx(theirs.at<double>(i / 3, i % 3)).epsilon(1e-4));
  }
}

TEST_CASE("poses of a square: both solutions of IPPE, refined at least as well") {
  Random random(9);
  constexpr double kHalf = 0.05, kFocal = 600.0;
  Eigen::Matrix<double, 4, 3> square;
  square << -kHalf, kHalf, 0, kHalf, kHalf, 0, kHalf, -kHalf, 0, -kHalf, -kHalf, 0;
  int agree = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Isometry3d T = random_view(random);
    PlanePoints seen(4, 2);
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> pixels;
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector3d p = T * Eigen::Vector3d(square.row(i).transpose());
      seen.row(i) << p.x() / p.z() + bell(random) * 0.2 / kFocal,
          p.y() / p.z() + bell(random) * 0.2 / kFocal;
      points.emplace_back(square(i, 0), square(i, 1), 0);
      pixels.emplace_back(seen(i, 0), seen(i, 1));
    }
    std::vector<cv::Vec3d> r, t;
    cv::solvePnPGeneric(points, pixels, cv::Matx33d::eye(), cv::noArray(), r, t, false,
                        cv::SOLVEPNP_IPPE);
    const auto ours = planar_pose(square, seen);
    REQUIRE(ours.ok());
    const auto error_of = [&](const cv::Vec3d& rotation, const cv::Vec3d& translation) {
      std::vector<cv::Point2d> back;
      cv::projectPoints(points, rotation, translation, cv::Matx33d::eye(), cv::noArray(), back);
      double sum = 0.0;
      for (int i = 0; i < 4; ++i) sum += std::pow(cv::norm(back[i] - pixels[i]), 2);
      return std::sqrt(sum / 4);
    };
    const double theirs = std::min(error_of(r[0], t[0]), r.size() > 1 ? error_of(r[1], t[1]) : 1e9);
    CHECK(ours->best.error <= theirs + 1e-9);
    cv::Matx33d R;
    cv::Rodrigues(r[0], R);
    Eigen::Matrix3d turned;
    for (int i = 0; i < 9; ++i) turned(i / 3, i % 3) = R.val[i];
    const double off =
        Eigen::AngleAxisd(ours->best.T_camera_obj.linear().transpose() * turned).angle();
    if (off < 0.05) ++agree;
  }
  MESSAGE(agree << " of 200 orientations within 0.05 rad of OpenCV's better one");
  CHECK(agree > 170);
}

TEST_CASE("projection with distortion equals projectPoints") {
  Random random(2);
  for (int trial = 0; trial < 500; ++trial) {
    Intrinsics lens{.fx = 612, .fy = 598, .cx = 310, .cy = 251};
    lens.distortion = {random_between(random, -0.1, 0.1), random_between(random, -0.02, 0.02),
                       random_between(random, -0.005, 0.005), random_between(random, -0.005, 0.005),
                       random_between(random, -0.01, 0.01)};
    const Eigen::Vector3d p(random_between(random, -0.4, 0.4), random_between(random, -0.3, 0.3),
                            1.0);
    const auto ours = Pinhole(lens).project(p);
    REQUIRE(ours.ok());
    std::vector<cv::Point2d> theirs;
    cv::projectPoints(std::vector<cv::Point3d>{{p.x(), p.y(), p.z()}}, cv::Vec3d(0, 0, 0),
                      cv::Vec3d(0, 0, 0),
                      cv::Matx33d(lens.fx, 0, lens.cx, 0, lens.fy, lens.cy, 0, 0, 1),
                      cv::Matx<double, 1, 5>(lens.distortion.data()), theirs);
    CHECK(std::abs(ours->x() - theirs[0].x) < 1e-10);
    CHECK(std::abs(ours->y() - theirs[0].y) < 1e-10);
  }
}
