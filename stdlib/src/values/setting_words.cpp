#include "values/setting_words.hpp"

#include <algorithm>

#include "armlet/image/parameters.hpp"
#include "armlet/math/ode.hpp"

namespace armlet::bind {

std::span<const std::string_view> words_of_parameter(std::string_view parameter) {
  struct Row {
    std::string_view parameter;
    std::span<const std::string_view> words;
  };
  static const Row rows[] = {
      {"convention", kConventions}, {"inertias", kInertiaWords},
      {"frame", kJacobianFrames},   {"axes", kMaskAxes},
      {"posture", kPostures},       {"sequence", kEulerSequences},
      {"direction", kDirections},   {"axis", kAxisSides},
      {"log", kLogarithmicAxes},    {"method", ode_method_names()},
      {"use", kShapeUses},          {"light", kLightWords},
      {"law", kServoLaws},          {"dictionary", kMarkerDictionaries},
  };
  const auto* found = std::ranges::find(rows, parameter, &Row::parameter);
  return found != std::end(rows) ? found->words : std::span<const std::string_view>();
}

}  // namespace armlet::bind
