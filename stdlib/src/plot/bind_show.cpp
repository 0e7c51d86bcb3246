// Pictures in figures (language reference, section 16).

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "armlet/image/arithmetic.hpp"
#include "armlet/image/shown.hpp"
#include "plot/plots.hpp"
#include "values/world/pictures.hpp"

namespace armlet::bind {
namespace {

constexpr int kMostShown = 720;  // pixels along a side, as many as a figure is wide on a page

// The grey or RGB picture that is seen, and what stands below it.
struct Shown {
  Image image;
  std::string note;
};

bool is_mask(const Image& image) {
  const auto bytes = image.bytes();
  return image.kind() == PixelKind::kGrey &&
         std::ranges::all_of(bytes, [](std::uint8_t level) { return level <= 1; }) &&
         std::ranges::any_of(bytes, [](std::uint8_t level) { return level == 1; });
}

Shown shown_of(const Image& image) {
  Shown shown{image, fmt::format("{}, {}", size_of(image), kind_of(image.kind()))};
  if (image.kind() == PixelKind::kDepth) {
    const DepthRange range = depth_range(image);
    shown.image = grey_of_depths(image);
    shown.note += range.farthest == 0.0F
                      ? ": nothing is seen"
                      : fmt::format(": white {:.4g} m, dark {:.4g} m, black nothing", range.nearest,
                                    range.farthest);
  } else if (is_mask(image)) {
    shown.image = scaled(image, 255.0);
    shown.note += ": white 1";
  }
  const int longest = std::max(image.width(), image.height());
  if (longest > kMostShown) {
    const auto side = [longest](int pixels) {
      return std::max(
          1, static_cast<int>((std::int64_t{pixels} * kMostShown + longest / 2) / longest));
    };
    shown.image = resized(shown.image, side(image.width()), side(image.height()));
    shown.note += fmt::format(", reduced to {}", size_of(shown.image));
  }
  return shown;
}

bool takes_picture(const Figure& figure) { return figure.picture != nullptr || figure.is_empty(); }

// The figure of that title; without one the last figure, if it can show a picture. Null: a new one
// is needed.
Answer<Figure*> figure_for(Vm& vm, std::vector<Figure>& figures, OptionalText title) {
  if (!title) {
    const bool goes_on = !figures.empty() && takes_picture(figures.back());
    return goes_on ? &figures.back() : nullptr;
  }
  const auto found = std::ranges::find(figures, *title, &Figure::title);
  if (found == figures.end()) return nullptr;
  if (!takes_picture(*found)) {
    return failure(vm, "R0626",
                   fmt::format("the figure \"{}\" shows something else than a picture", *title),
                   at("title"), {}, "give the picture another title");
  }
  std::rotate(found, found + 1, figures.end());
  return &figures.back();
}

Answer<void> show(Vm& vm, const Image& image, OptionalText title) {
  constexpr std::uint64_t kCost = 8;  // operations for a byte
  const auto shown = with_pictures(vm, kCost * bytes_of(image), [&] { return shown_of(image); });
  if (!shown || !make_room(vm, shown->image.bytes().size() / sizeof(double),
                           "show pictures under the same title, where each replaces the last"))
    return Failed{};
  Host& host = Host::of(vm);
  const auto found = figure_for(vm, host.figures(), title);
  if (!found) return Failed{};
  Figure& figure =
      *found != nullptr ? **found : host.begin_figure({.title = text_or_nothing(title)});
  figure = {.title = std::move(figure.title),
            .picture = std::make_shared<const Image>(shown->image),
            .note = shown->note,
            .index = figure.index};
  return figure_changed(vm);
}

constexpr NativeFunction kShowFunctions[] = {
    def<show>(
        "show(img: image, title: string?)",
        "Shows a picture as the figure of this title, instead of the picture there; without a "
        "title, in the last figure if that is empty or shows a picture, otherwise in a new one. Of "
        "depths the nearest is white; in a mask of 0 and 1 the ones are. Pages show at most 720 "
        "pixels along a side, `--plots` and savePlot with .txt dots.",
        "show(image([0, 255; 255, 0]), \"checks\")"),
};

}  // namespace

std::span<const NativeFunction> show_functions() { return kShowFunctions; }

}  // namespace armlet::bind
