// Edges, lines, circles and templates by OpenCV (language reference, section 15).

#include "armlet/image/parameters.hpp"
#include "armlet/vision/edges.hpp"
#include "armlet/vision/opencv.hpp"
#include "armlet/vision/template_match.hpp"
#include "values/eigen_results.hpp"
#include "vision/opencv_needed.hpp"
#include "vision/picture_rules.hpp"

namespace armlet::bind {

Answer<void> opencv_for(Vm& vm, std::string_view function) {
  if (has_opencv()) return {};
  MissingOpencv missing = missing_opencv();
  Failure f;
  f.headline = {row("R0691"), {std::string(function)}};
  f.why = std::move(missing.why);
  f.fix = std::move(missing.fix);
  return fail(vm, std::move(f));
}

Answer<void> grey_for_opencv(Vm& vm, const Image& image, CallPart part) {
  if (image.kind() == PixelKind::kGrey) return {};
  return fail_picture(vm, "this function takes grey pictures", part, "gray({arg}) is one");
}

namespace {

std::uint64_t count_pixels(const Image& image) {
  return std::uint64_t{1} * image.width() * image.height();
}

Answer<Image> edges(Vm& vm, const Image& image, double low, double high) {
  if (!grey_for_opencv(vm, image)) return Failed{};
  return with_opencv(vm, "edges", 20 * count_pixels(image),
                     [&] { return find_edges(image, low, high); });
}

Answer<Eigen::MatrixXd> lines(Vm& vm, const Image& image, std::int64_t votes, double min_length,
                              double max_gap) {
  if (!grey_for_opencv(vm, image)) return Failed{};
  const auto whole = static_cast<double>(votes);
  return with_opencv(vm, "lines", 20 * count_pixels(image), [&]() -> Eigen::MatrixXd {
    check_picture_parameter("lines", "votes", whole);
    return find_lines(image, {static_cast<int>(votes), min_length, max_gap});
  });
}

Answer<Eigen::MatrixXd> circles(Vm& vm, const Image& image, std::int64_t min_radius,
                                std::int64_t max_radius, double distance, double edge,
                                double roundness) {
  if (!grey_for_opencv(vm, image)) return Failed{};
  return with_opencv(vm, "circles", 60 * count_pixels(image), [&]() -> Eigen::MatrixXd {
    check_picture_parameter("circles", "minRadius", static_cast<double>(min_radius));
    check_picture_parameter("circles", "maxRadius", static_cast<double>(max_radius));
    return find_circles(image, {static_cast<int>(min_radius), static_cast<int>(max_radius),
                                distance, edge, roundness});
  });
}

Answer<RecordObj*> match(Vm& vm, const Image& image, const Image& part) {
  const auto found = with_opencv(vm, "match", 60 * count_pixels(image),
                                 [&] { return match_template(image, part); });
  if (!found) return Failed{};
  RecordObj* record = new_record(vm, vm.program().library_record("Match"));
  if (record == nullptr) return Failed{};
  record->fields()[0].d = found->x;
  record->fields()[1].d = found->y;
  record->fields()[2].d = found->score;
  return record;
}

#define ARMLET_SHOWN_BOX                                                                          \
  "var m = zeros(60, 80); for (y in range(20, 40)) { for (x in range(30, 55)) { m[y, x] = 200 } " \
  "} "                                                                                            \
  "let img = image(m); "

constexpr NativeFunction kOpencvFunctions[] = {
    def<edges>("edges(img: image, low: double = 50.0, high: double = 150.0) -> image",
               "The edges of a grey picture, one pixel wide, in white on black, by J. Canny's "
               "method. An edge begins where the gradient is above high and goes on while it is "
               "above low, 0 to 1500; a step from black to white has about 1000. Needs OpenCV.",
               ARMLET_SHOWN_BOX "print(edges(img)[29, 30])",
               {.check = gives_kind<PixelKind::kGrey>}),
    def<lines>(
        "lines(img: image, votes: int = 40, minLength: double = 30.0, maxGap: double = 5.0) "
        "-> matrix",
        "Segments of straight lines in a picture of edges, from the longest to the "
        "shortest: a row x0, y0, x1, y1 with both ends in pixels for each, fitted to the "
        "edges. votes: how many pixels a line has at least, 10 to 100000; minLength: shorter "
        "segments are left out, 0 to 20000 px; maxGap: pieces nearer to each other are one "
        "segment, 0 to 100 px. At most 50000 pixels may be white. Needs OpenCV.",
        ARMLET_SHOWN_BOX "print(lines(edges(img), votes: 10, minLength: 15.0).rows)"),
    def<circles>("circles(img: image, minRadius: int = 5, maxRadius: int = 200, distance: double = "
                 "20.0, edge: double = 100.0, roundness: double = 0.8) -> matrix",
                 "Circles in a grey picture, from the best to the worst: a row x, y, radius in "
                 "pixels for each, fitted to the edges. minRadius, maxRadius: 1 to 1000 px; "
                 "distance: centres are at least so far apart, 5 px or more; edge: how large a "
                 "gradient is on a circle, 1 to 1000, above which at most 30000 pixels may be; "
                 "roundness: how round it has to be, 0.5 to 1. Needs OpenCV.",
                 "print(circles(image(zeros(60, 80))).rows)"),
    def<match>("match(img: image, template: image) -> Match",
               "Where a small picture fits best into a large one: the pixel x, y of its middle, to "
               "fractions of a pixel, and a score up to 1, which is a perfect fit but for "
               "brightness and contrast. Both are grey or both RGB. Needs OpenCV.",
               ARMLET_SHOWN_BOX "print(match(img, img[25:40, 15:30]).x)"),
};

}  // namespace

std::span<const NativeFunction> opencv_functions() { return kOpencvFunctions; }

}  // namespace armlet::bind
