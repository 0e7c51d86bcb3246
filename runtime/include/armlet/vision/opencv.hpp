#pragma once
// Functions of OpenCV are in a library of their own, which is loaded when one of them is first
// called. Their results may differ between versions of OpenCV and processors.

#include <string>

namespace armlet {

// Whether that library can be loaded; loads it.
[[nodiscard]] bool has_opencv();

// Why it cannot be loaded, and what to do, as parts of a sentence; the text differs in a page.
struct MissingOpencv {
  std::string why;
  std::string fix;
};
[[nodiscard]] MissingOpencv missing_opencv();

}  // namespace armlet
