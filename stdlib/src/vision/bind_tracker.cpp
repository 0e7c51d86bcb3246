// Points tracked from picture to picture (language reference, section 15).

#include <fmt/format.h>

#include <memory>

#include "armlet/image/parameters.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/vision/corners.hpp"
#include "rules/rules_settings.hpp"
#include "values/eigen_results.hpp"
#include "values/setting_words.hpp"
#include "values/world/cameras.hpp"
#include "values/world/pictures.hpp"
#include "vision/features.hpp"

namespace armlet::bind {

// The value of a `tracker` of the language; it changes.
struct TrackerValue {
  struct State {
    PointTracker points;
    double gate;
    CornerOptions corners;
  };
  std::shared_ptr<State> state;
};

const HostType kTracker = {
    .name = "tracker",
    .size = sizeof(TrackerValue),
    .is_handle = true,
    .destroy = [](void* value) { static_cast<TrackerValue*>(value)->~TrackerValue(); },
    .equal =
        [](const void* a, const void* b) {
          return static_cast<const TrackerValue*>(a)->state ==
                 static_cast<const TrackerValue*>(b)->state;
        },
    .text =
        [](const void* value, std::string& out) {
          const auto& state = *static_cast<const TrackerValue*>(value)->state;
          out += fmt::format("tracker of {} points", state.points.points().rows());
        },
    .help =
        "Points that are followed from picture to picture. Another name for it is the same "
        "tracker.",
    .noun = "a tracker"};

}  // namespace armlet::bind

namespace armlet {
template <>
inline constexpr const HostType* kHostType<bind::TrackerValue> = &bind::kTracker;
}  // namespace armlet

namespace armlet::bind {
namespace {

Answer<TrackerValue> track(Vm& vm, const MatrixObj& start, double gate, std::int64_t patience,
                           std::string_view method, std::int64_t threshold) try {
  const auto points = pixels_of(vm, start, at("start"));
  const auto found_by = points ? corner_method(vm, method, at("method")) : Failed{};
  if (!found_by) return Failed{};
  const auto check = [](std::string_view name, std::string_view of_corners, double value) {
    check_picture_parameter_as("track", name, picture_parameter("corners", of_corners), value);
  };
  check("gate", "within", gate);
  check("threshold", "threshold", static_cast<double>(threshold));
  if (patience < 0 || patience > 1'000'000)
    return fail_picture(vm,
                        fmt::format("`patience` of `track` is {}; expected 0 to 1000000", patience),
                        at("patience"));
  return TrackerValue{std::make_shared<TrackerValue::State>(TrackerValue::State{
      PointTracker(*points, gate, static_cast<int>(patience)), gate,
      CornerOptions{.method = *found_by, .threshold = static_cast<int>(threshold)}})};
} catch (const ArgumentError& error) {
  return fail_picture(vm, clause_of(error));
}

Answer<PlanePoints> update(Vm& vm, const TrackerValue& tracker, const Image& image,
                           std::optional<Slot> predicted) try {
  TrackerValue::State& state = *tracker.state;
  if (!searchable(vm, image)) return Failed{};
  const auto expected = predicted ? pixels_of(vm, matrix_value(*predicted), at("predicted"))
                                  : Answer<PlanePoints>(state.points.expected());
  if (!expected) return Failed{};
  const auto found =
      few_enough(vm, find_corners_around(image, *expected, 2.0 * state.gate, state.corners));
  if (!found) return Failed{};
  const PlanePoints now = state.points.update(*found, *expected);
  std::vector<int> lost = state.points.lost();
  if (lost.empty()) return now;
  return fail_lost(vm, {now, std::move(lost), state.gate},
                   match_points(*found, now, state.gate).distance, CallPart::first());
} catch (const ArgumentError& error) {
  return fail_picture(vm, clause_of(error));
}

PlanePoints tracked(const TrackerValue& tracker) { return tracker.state->points.points(); }

std::vector<std::int64_t> missed_rows(const TrackerValue& tracker) {
  std::vector<std::int64_t> rows;
  const auto& missed = tracker.state->points.missed();
  for (std::size_t i = 0; i < missed.size(); ++i)
    if (missed[i] > 0) rows.push_back(static_cast<std::int64_t>(i));
  return rows;
}

Obj* missed(Vm& vm, const TrackerValue& tracker) {
  const auto rows = missed_rows(tracker);
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(rows.size()), false);
  for (std::size_t i = 0; list != nullptr && i < rows.size(); ++i) list->data[i].i = rows[i];
  return list;
}

#define ARMLET_SHOWN_TRACK                                                                        \
  "var m = zeros(60, 80); for (y in range(20, 40)) { for (x in range(30, 55)) { m[y, x] = 200 } " \
  "} "                                                                                            \
  "let tr = track([30, 20; 54, 39], gate: 5.0); "

constexpr NativeFunction kTrackerFunctions[] = {
    def<track>(
        "track(start: matrix, gate: double = 12.0, patience: int = 5, method: string = \"harris\", "
        "threshold: int = 20) -> tracker",
        "Follows points, the rows x, y of start in pixels, from picture to picture. A corner "
        "counts as a point if it is within gate px of where that is expected; one that is not "
        "found stays there for at most patience pictures. method and threshold are those of "
        "corners. "
        "A tracker remembers: update changes it, by whichever name; track(tr.points) starts "
        "another from where the points are now.",
        ARMLET_SHOWN_TRACK "print(tr)",
        {.check = check_word<"method", kCornerMethods>, .acts = true}),
    def<update>("update(tr: tracker, img: image, predicted: matrix?) -> matrix",
                "The points in the next grey picture, in the order of the start. predicted: where "
                "they are expected; otherwise where they were, plus what they moved by before. "
                "FeatureLost names those that were not found for more pictures than patience.",
                ARMLET_SHOWN_TRACK "print(tr.update(image(m)))", {.acts = true}),
    def<tracked>("tracker.points(tr: tracker) -> matrix", "The points as they were found last.",
                 ARMLET_SHOWN_TRACK "print(tr.points)"),
    def<missed>("tracker.lost(tr: tracker) -> int[]",
                "The rows of the points that were not found in the last picture.",
                ARMLET_SHOWN_TRACK "print(tr.lost)"),
};

}  // namespace

std::span<const NativeFunction> tracker_functions() { return kTrackerFunctions; }

}  // namespace armlet::bind
