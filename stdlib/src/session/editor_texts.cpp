#include "editor_texts.hpp"

#include <utility>

#include "motion/setting_choices.hpp"
#include "rules/rules.hpp"
#include "values/setting_words.hpp"

namespace armlet {

std::function<std::vector<std::string>(const NativeFunction&, std::string_view)> editor_texts(
    std::vector<std::string> planners, std::shared_ptr<const WorldNames> world) {
  return [planners = std::move(planners), world = std::move(world)](const NativeFunction& function,
                                                                    std::string_view parameter) {
    const bool names_object = function.check == bind::check_object_name;
    const bool makes_trajectory = function.name == "trajectory";
    if (parameter == "traj" || (makes_trajectory && parameter == "name")) return planners;
    if (function.name.starts_with("with.")) return bind::choices_of_setting(parameter);
    if (const auto words = bind::words_of_parameter(parameter); !words.empty())
      return std::vector<std::string>(words.begin(), words.end());
    if (names_object && world != nullptr) return world->things;
    return std::vector<std::string>();
  };
}

}  // namespace armlet
