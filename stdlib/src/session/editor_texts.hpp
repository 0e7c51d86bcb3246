#pragma once
// Texts that editors may offer between quotes.

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"
#include "armlet/interpreter/world_names.hpp"

namespace armlet {

// The texts that a parameter of the library may have (CompileOptions::texts): names of planners and
// of objects of the world, and values of settings.
[[nodiscard]] std::function<std::vector<std::string>(const NativeFunction&, std::string_view)>
editor_texts(std::vector<std::string> planners, std::shared_ptr<const WorldNames> world);

}  // namespace armlet
