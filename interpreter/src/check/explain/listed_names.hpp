#pragma once
// Lists of names in messages.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// "R, T and x": the names there are where `asked` is none. Numbered ones stand together ("q1 to
// q12"); of very many those that are most like `asked`, and how many others there are.
[[nodiscard]] std::string listed_names(std::string_view asked,
                                       const std::vector<std::string>& names);

}  // namespace armlet::lang
