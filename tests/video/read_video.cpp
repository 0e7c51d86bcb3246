// Reads a video and the pictures that it was made of: read_video FILE FOLDER prints how many pictures
// the video has, their size and rate, the largest difference to frame-000000.png and so on, and the
// one between the first and the middle picture of the video, both in grey levels: means of squares
// of 16 pixels are compared, which H.264 keeps and a moving arm changes.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "armlet/core/files.hpp"
#include "armlet/image/files.hpp"

namespace {

constexpr int kSquare = 16;  // px

// Mean of the three channels in each square, row by row.
std::vector<double> means_of(int width, int height, const std::uint8_t* (*row)(const void*, int),
                             const void* picture) {
  const int columns = (width + kSquare - 1) / kSquare, rows = (height + kSquare - 1) / kSquare;
  std::vector<double> sums(static_cast<std::size_t>(columns * rows));
  for (int y = 0; y < height; ++y) {
    const std::uint8_t* pixels = row(picture, y);
    for (int i = 0; i < 3 * width; ++i)
      sums[static_cast<std::size_t>(y / kSquare * columns + i / 3 / kSquare)] += pixels[i];
  }
  for (double& sum : sums) sum /= 3.0 * kSquare * kSquare;
  return sums;
}

std::vector<double> means_of(const cv::Mat& picture) {
  return means_of(
      picture.cols, picture.rows,
      [](const void* of, int y) -> const std::uint8_t* {
        return static_cast<const cv::Mat*>(of)->ptr(y);
      },
      &picture);
}

std::vector<double> means_of(const armlet::Image& picture) {
  return means_of(
      picture.width(), picture.height(),
      [](const void* of, int y) { return static_cast<const armlet::Image*>(of)->row(y); },
      &picture);
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

armlet::Image picture_in(const std::string& folder, int number) {
  char name[32];
  std::snprintf(name, sizeof name, "/frame-%06d.png", number);
  const auto bytes = armlet::read_file(folder + name, std::size_t{64} << 20U);
  if (!bytes.ok()) return {};
  auto image = armlet::read_image(*bytes);
  return image.ok() ? *image : armlet::Image();
}

}  // namespace

int main(int count, char** words) {
  if (count != 3) return 2;
  cv::VideoCapture reader(words[1], cv::CAP_FFMPEG);
  if (!reader.isOpened()) {
    std::fprintf(stderr, "read_video: %s cannot be read\n", words[1]);
    return 1;
  }
  std::vector<std::vector<double>> means;
  double worst = 0.0;
  int width = 0, height = 0;
  for (cv::Mat picture; reader.read(picture);) {
    const armlet::Image image = picture_in(words[2], static_cast<int>(means.size()));
    width = picture.cols;
    height = picture.rows;
    if (image.width() != width || image.height() != height) {
      std::fprintf(stderr, "read_video: picture %zu has another size, or is missing\n",
                   means.size());
      return 1;
    }
    means.push_back(means_of(picture));
    worst = std::max(worst, difference(means.back(), means_of(image)));
  }
  if (means.empty()) return 1;
  std::printf("%zu %d %d %g %g %g\n", means.size(), width, height, reader.get(cv::CAP_PROP_FPS),
              worst, difference(means.front(), means[means.size() / 2]));
}
