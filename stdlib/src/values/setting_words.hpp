#pragma once
// The words of settings with a few possible words: "standard" or "modified". The checks before the
// run and in the run, and the editor, use these lists.

#include <array>
#include <span>
#include <string_view>

#include "armlet/interpreter/host/table_text.hpp"

namespace armlet::bind {

// In the order of DhConvention.
inline constexpr std::array<std::string_view, 2> kConventions = {"standard", "modified"};
// In the order of InertiaCheck.
inline constexpr std::array<std::string_view, 2> kInertiaWords = {"rigid", "published"};
inline constexpr std::array<std::string_view, 3> kJacobianFrames = {"world", "base", "tool"};
inline constexpr std::array<std::string_view, 2> kMaskAxes = {"world", "tool"};
inline constexpr std::array<std::string_view, 2> kPostures = {"midRange", "manipulability"};
inline constexpr std::array<std::string_view, 12> kEulerSequences = {
    "XYX", "XZX", "YXY", "YZY", "ZXZ", "ZYZ", "XYZ", "XZY", "YXZ", "YZX", "ZXY", "ZYX"};
// In the order of CrossingDirection.
inline constexpr std::array<std::string_view, 3> kDirections = {"both", "rising", "falling"};
inline constexpr std::array<std::string_view, 2> kAxisSides = {"left", "right"};
inline constexpr std::array<std::string_view, 4> kLogarithmicAxes = {"x", "y", "xy", "yx"};

// In the order of ServoLaw.
inline constexpr std::array<std::string_view, 5> kServoLaws = {"current", "desired", "mean",
                                                               "position", "hybrid"};
// In the order of HandEyeMethod.
inline constexpr std::array<std::string_view, 4> kHandEyeMethods = {"tsai", "park", "horaud",
                                                                    "daniilidis"};
// The settings of the light of a camera: with shading and shadows, or without.
inline constexpr std::array<std::string_view, 2> kLightWords = {"key", "flat"};

// The use of the shape of a link, in the order of LinkSolidUse.
inline constexpr std::array<std::string_view, 3> kShapeUses = {"both", "picture", "collision"};

inline constexpr std::array<std::string_view, 2> kPictureEndings = {".svg", ".txt"};
inline constexpr std::array<std::string_view, 5> kImageEndings = {".png", ".jpg", ".jpeg", ".pgm",
                                                                  ".ppm"};
inline constexpr std::array<std::string_view, 3> kSnapshotEndings = {".png", ".jpg", ".jpeg"};
inline constexpr std::array<std::string_view, 1> kTableEndings = {kTableEnding};

// The planner whose path is a straight line in joint space.
inline constexpr std::string_view kPathPlanner = "Syn";

// The words of the parameter with that name; empty if it takes any text.
[[nodiscard]] std::span<const std::string_view> words_of_parameter(std::string_view parameter);

}  // namespace armlet::bind
