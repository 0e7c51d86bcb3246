#include "video/video.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "armlet/camera/renderer.hpp"
#include "armlet/cell/cell.hpp"
#include "armlet/cell/clock.hpp"
#include "commands.hpp"
#include "console/console.hpp"
#include "storyboard/lettering.hpp"

namespace armlet::cli {
namespace {

constexpr std::int64_t kPeriodNs = kNanosecondsPerSecond / kVideoRate;
constexpr int kMargin = 14;  // px between the time and the border

// Says how far the drawing is: in the last line of a terminal, or as a line every ten seconds.
class DrawingProgress {
 public:
  explicit DrawingProgress(bool talks) : talks_(talks) {}
  ~DrawingProgress() {
    if (shown_) status_line({});
  }
  DrawingProgress(const DrawingProgress&) = delete;
  DrawingProgress& operator=(const DrawingProgress&) = delete;

  void tell(std::size_t done, std::size_t all) {
    const auto now = std::chrono::steady_clock::now();
    const bool line = shows_status();
    if (!talks_ || now - last_ < (line ? std::chrono::milliseconds(100) : std::chrono::seconds(10)))
      return;
    last_ = now;
    const std::string text = fmt::format("video: {} of {} pictures", done, all);
    if (line) {
      status_line(text);
      shown_ = true;
    } else {
      progress(text);
    }
  }

 private:
  bool talks_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

int Video::choose(const std::string& path) {
  if (path.empty()) return kDone;
  path_ = path;
  sink_ = video_sink(path);
  return sink_ != nullptr ? kDone : kUsage;
}

int Video::open(const std::vector<std::string>& texts) {
  return is_wanted() ? sink_->open(texts) : kDone;
}

void Video::look(const Cell& cell) {
  const std::int64_t now = cell.now_ns();
  if (!is_wanted() || is_cut_ || now % kPeriodNs != 0 || now <= last_look_ns_) return;
  is_cut_ = scenes_.size() == kMostPictures;
  if (is_cut_) return;
  last_look_ns_ = now;
  keep(cell);
}

void Video::keep(const Cell& cell) {
  const Scene scene = cameras_.scene(cell);
  scenes_.add(scene);
  if (!scenes_.is_as_before(scenes_.size() - 1)) view_.add(cell, scene);
}

int Video::finish(const Cell& cell, bool talks) {
  if (!is_wanted()) return kDone;
  end_ns_ = cell.now_ns();
  if (!is_cut_ && last_look_ns_ < end_ns_) keep(cell);
  if (talks && interrupted())
    progress("  the video is drawn as far as the run went; another Ctrl-C leaves it out");
  if (const int exit = draw(talks); exit != kDone) return exit;
  if (const int exit = sink_->finish(); exit != kDone) return exit;
  const double seconds = static_cast<double>(scenes_.size()) / kVideoRate;
  if (is_cut_) {
    progress(
        fmt::format("  the video shows the first {} s of {:.2f} s", seconds, to_seconds(end_ns_)));
  } else if (talks) {
    progress(fmt::format("  video in {}: {} picture{}, {:.2f} s", path_, scenes_.size(),
                         scenes_.size() == 1 ? "" : "s", seconds));
  }
  return kDone;
}

int Video::draw(bool talks) {
  const Viewpoint from = view_.viewpoint();
  Renderer renderer;
  Pictures pictures;
  DrawingProgress drawing(talks);
  for (std::size_t i = 0; i < scenes_.size(); ++i) {
    drawing.tell(i, scenes_.size());
    if (!scenes_.is_as_before(i))
      renderer.render(scenes_.at(i), from.lens, from.T_world_camera, {.samples = 4}, pictures);
    Image picture = pictures.color;
    const std::int64_t t_ns = std::min(static_cast<std::int64_t>(i) * kPeriodNs, end_ns_);
    write(picture, kMargin, kVideoHeight - kMargin - kLetterHeight,
          fmt::format("{:.2f} s", to_seconds(t_ns)), kInk);
    if (const int exit = sink_->add(picture); exit != kDone) return exit;
  }
  return kDone;
}

}  // namespace armlet::cli
