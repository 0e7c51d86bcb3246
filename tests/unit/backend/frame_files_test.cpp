#include "armlet/backend/frame_files.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "armlet/core/files.hpp"
#include "armlet/image/files.hpp"
#include "temporary_folder.hpp"

using namespace armlet;

namespace {

// Keeps the pictures that it receives, and counts the other events.
class FileListener : public Backend {
 public:
  void on(const Event& event) override {
    const auto* frame = std::get_if<ImageFrame>(&event);
    if (frame == nullptr) {
      ++others;
    } else {
      files.emplace_back(frame->file);
    }
  }
  std::vector<std::string> files;
  int others = 0;
};

}  // namespace

TEST_CASE("pictures are written as they are, and passed on with the names of their files") {
  const TemporaryFolder folder;
  FileListener listener;
  FrameFiles files(folder.path().string(), &listener);
  files.open();
  const std::vector<std::uint8_t> grey{0, 50, 100, 150, 200, 250};
  const std::vector<std::uint8_t> rgb{1, 2, 3, 40, 50, 60};
  files.on(BeginRun{});
  files.on(ImageFrame{
      .camera = "eye", .frame = 7, .width = 3, .height = 2, .channels = 1, .pixels = grey});
  files.on(ImageFrame{.camera = "eye", .frame = 8, .width = 2, .height = 1, .pixels = rgb});
  files.on(EndRun{});
  CHECK(files.error().empty());
  CHECK(files.written() == 2);
  CHECK(listener.others == 2);
  REQUIRE(listener.files.size() == 2);
  CHECK(listener.files[0] == (folder.path() / "eye-000007.png").string());
  const Result<Image> first = read_image(read_file(listener.files[0], 1 << 20).value());
  REQUIRE(first.ok());
  CHECK(first->kind() == PixelKind::kGrey);
  CHECK(std::ranges::equal(first->bytes(), grey));
  const Result<Image> second = read_image(read_file(listener.files[1], 1 << 20).value());
  REQUIRE(second.ok());
  CHECK(second->width() == 2);
  CHECK(std::ranges::equal(second->bytes(), rgb));
}

TEST_CASE("a picture that cannot be written is an error, and is passed on without a file") {
  FileListener listener;
  FrameFiles files("/there/is/no/such/folder", &listener);
  files.open();
  const std::vector<std::uint8_t> rgb{1, 2, 3};
  files.on(ImageFrame{.camera = "eye", .width = 1, .height = 1, .pixels = rgb});
  CHECK(files.error().find("/there/is/no/such/folder") != std::string::npos);
  CHECK(files.written() == 0);
  CHECK(listener.files == std::vector<std::string>{""});
  const TemporaryFolder folder;
  FrameFiles bad_name(folder.path().string(), nullptr);
  bad_name.open();
  bad_name.on(ImageFrame{.camera = "../eye", .width = 1, .height = 1, .pixels = rgb});
  CHECK(bad_name.error().find("eye-000000.png") != std::string::npos);
  CHECK_FALSE(bad_name.ignores().has(EventKind::kImageFrame));
  CHECK(bad_name.ignores().has(EventKind::kJointSample));
}
