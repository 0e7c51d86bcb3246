#pragma once

#include <string_view>

#include "values/world/pictures.hpp"

namespace armlet::bind {

// Writes the picture into a file in the format of its name; otherwise R0680 or R0681, which mark
// `part`.
Answer<void> save_picture(Vm& vm, const Image& image, std::string_view file, CallPart part);

}  // namespace armlet::bind
