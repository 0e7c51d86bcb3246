#include "storyboard/storyboard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "armlet/image/files.hpp"
#include "console/console.hpp"
#include "storyboard/lettering.hpp"

namespace armlet::cli {
namespace {

constexpr std::size_t kMostFrames = 60;
constexpr int kGap = 12;                    // between pictures and around them
constexpr int kLabel = kLetterHeight + 12;  // height of a label below a picture
constexpr std::uint8_t kPaper = 255;

// About as many columns as rows, or one more if that leaves fewer cells empty.
int columns_of(int count) {
  const int square = static_cast<int>(std::ceil(std::sqrt(count)));
  const auto left_free = [&](int columns) { return (columns - count % columns) % columns; };
  return count > 1 && left_free(square + 1) < left_free(square) ? square + 1 : square;
}

void put(Image& sheet, const Image& picture, int left, int top) {
  const auto bytes = static_cast<std::ptrdiff_t>(picture.width()) * picture.channels();
  for (int y = 0; y < picture.height(); ++y) {
    std::copy_n(picture.row(y), bytes,
                sheet.row(top + y) + static_cast<std::ptrdiff_t>(left) * sheet.channels());
  }
}

}  // namespace

int Storyboard::choose(const std::string& path) {
  if (path.empty() || path.ends_with(".png")) {
    file_.set_path(path);
    return kDone;
  }
  progress(fmt::format("armlet: a storyboard is a .png file, not \"{}\"", path));
  return kUsage;
}

int Storyboard::open(const std::vector<std::string>& texts) {
  return is_wanted() ? file_.open(texts) : kDone;
}

void Storyboard::take(const FinishedMove& move, const Cell& cell) {
  if (!is_wanted() || moves_++ % each_ != 0) return;
  if (frames_.size() == kMostFrames) {
    for (std::size_t i = 0; 2 * i < frames_.size(); ++i) std::swap(frames_[i], frames_[2 * i]);
    frames_.resize((frames_.size() + 1) / 2);
    each_ *= 2;
    if ((moves_ - 1) % each_ != 0) return;
  }
  Scene scene = cameras_.scene(cell);
  view_.add(cell, scene);
  frames_.push_back({fmt::format("{}  {} {}  {:.2f} s{}", moves_, move.robot, move.function,
                                 move.start + move.duration, move.stopped ? ", stopped" : ""),
                     std::move(scene)});
}

Image Storyboard::sheet() const {
  const int count = std::max(1, static_cast<int>(frames_.size()));
  const int columns = columns_of(count);
  const int rows = (count + columns - 1) / columns;
  Image sheet(kGap + columns * (kPictureWidth + kGap),
              kGap + rows * (kPictureHeight + kLabel + kGap), PixelKind::kRgb);
  for (int y = 0; y < sheet.height(); ++y)
    std::fill_n(sheet.row(y), static_cast<std::ptrdiff_t>(sheet.width()) * 3, kPaper);
  if (frames_.empty()) {
    write(sheet, kGap, kGap, "no moves", kInk);
    return sheet;
  }
  const Viewpoint from = view_.viewpoint();
  for (int i = 0; i < count; ++i) {
    const Frame& frame = frames_[static_cast<std::size_t>(i)];
    const int left = kGap + i % columns * (kPictureWidth + kGap);
    const int top = kGap + i / columns * (kPictureHeight + kLabel + kGap);
    put(sheet, picture_from(from, frame.scene), left, top);
    write(sheet, left, top + kPictureHeight + (kLabel - kLetterHeight) / 2,
          fitted(frame.label, kPictureWidth), kInk);
  }
  return sheet;
}

int Storyboard::finish() {
  if (!is_wanted()) return kDone;
  file_.file().write(write_png(sheet()));
  if (const int exit = file_.finish(); exit != kDone) return exit;
  if (each_ > 1) {
    progress(fmt::format("  the storyboard shows {} of {} moves, every {}{}", frames_.size(),
                         moves_, each_, each_ == 2 ? "nd" : "th"));
  }
  return kDone;
}

}  // namespace armlet::cli
