// What the library writes is read back by OpenCV: how many pictures, how large, and what is on
// them.
#include "video/video_door.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <vector>

#include "temporary_folder.hpp"

using namespace armlet::cli;

namespace {

constexpr int kWidth = 96, kHeight = 64;

struct Refusal {
  std::string why;
  VideoRefusal door{
      this, [](void* context, const char* text) { static_cast<Refusal*>(context)->why = text; }};
};

// Red to the left of a border that moves to the right, blue to its right.
std::vector<std::uint8_t> picture_of(int number) {
  std::vector<std::uint8_t> rgb(static_cast<std::size_t>(kWidth * kHeight) * 3);
  for (int i = 0; i < kWidth * kHeight; ++i)
    rgb[static_cast<std::size_t>(3 * i + (i % kWidth < 8 * number ? 0 : 2))] = 230;
  return rgb;
}

std::string why_not(const std::string& path, int width, int height, double rate) {
  Refusal refusal;
  const VideoFormat format{path.c_str(), width, height, rate};
  void* const video = video_door()->open(&format, &refusal.door);
  CHECK(video == nullptr);
  return refusal.why;
}

}  // namespace

TEST_CASE("the library is there") { REQUIRE(video_door() != nullptr); }

TEST_CASE("a video has the pictures that were added, in their order, colours and rate") {
  const TemporaryFolder folder;
  for (const char* const name : {"a.mp4", "a.mkv"}) {
    CAPTURE(name);
    const std::string path = (folder.path() / name).string();
    Refusal refusal;
    const VideoFormat format{path.c_str(), kWidth, kHeight, 25.0};
    void* const video = video_door()->open(&format, &refusal.door);
    REQUIRE(video != nullptr);
    for (int i = 0; i < 12; ++i)
      REQUIRE(video_door()->add(video, picture_of(i).data(), &refusal.door));
    REQUIRE(video_door()->close(video, &refusal.door));
    CHECK(refusal.why.empty());

    cv::VideoCapture reader(path, cv::CAP_FFMPEG);
    REQUIRE(reader.isOpened());
    CHECK(reader.get(cv::CAP_PROP_FPS) == doctest::Approx(25.0));
    cv::Mat picture;
    int count = 0;
    for (; reader.read(picture); ++count) {
      REQUIRE(picture.cols == kWidth);
      REQUIRE(picture.rows == kHeight);
      // H.264 is not exact: 20 grey levels, 3 pixels from the border.
      for (int x = 0; x < kWidth; ++x) {
        if (std::abs(x - 8 * count) < 3) continue;
        const cv::Vec3b bgr = picture.at<cv::Vec3b>(kHeight / 2, x);
        CHECK(std::abs(bgr[2] - (x < 8 * count ? 230 : 0)) < 20);
        CHECK(std::abs(bgr[0] - (x < 8 * count ? 0 : 230)) < 20);
      }
    }
    CHECK(count == 12);
  }
}

TEST_CASE("sizes, rates and names that cannot be are refused, and nothing is left") {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.mp4").string();
  CHECK(why_not(path, 95, 64, 25).find("even numbers up to 8192, not 95 x 64 pixels") !=
        std::string::npos);
  CHECK(why_not(path, 96, 63, 25).find("not 96 x 63") != std::string::npos);
  CHECK(why_not(path, 0, 0, 25).find("not 0 x 0") != std::string::npos);
  CHECK(why_not(path, -2, 64, 25).find("not -2 x 64") != std::string::npos);
  CHECK(why_not(path, 8194, 64, 25).find("not 8194 x 64") != std::string::npos);
  CHECK(why_not(path, 96, 64, 0.0).find("pictures a second") != std::string::npos);
  CHECK(why_not(path, 96, 64, std::nan("")).find("pictures a second") != std::string::npos);
  CHECK(why_not((folder.path() / "a.avi").string(), 96, 64, 25).find("neither in .mp4") !=
        std::string::npos);
  CHECK(why_not((folder.path() / "no" / "a.mp4").string(), 96, 64, 25).find("cannot write H.264") !=
        std::string::npos);
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a video that was cut is not taken for whole") {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "a.mp4").string();
  Refusal refusal;
  const VideoFormat format{path.c_str(), kWidth, kHeight, 25.0};
  void* const video = video_door()->open(&format, &refusal.door);
  REQUIRE(video != nullptr);
  for (int i = 0; i < 5; ++i)
    REQUIRE(video_door()->add(video, picture_of(i).data(), &refusal.door));
  std::filesystem::remove(path);  // as a disk that is full takes nothing
  CHECK_FALSE(video_door()->close(video, &refusal.door));
  CHECK(refusal.why == "of 5 pictures only 0 can be read back");
}
