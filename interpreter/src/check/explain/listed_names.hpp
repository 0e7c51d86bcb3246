#pragma once
// Lists of names in messages.

#include <string>
#include <string_view>
#include <vector>

namespace armlet::lang {

// A list such as "R, T and x": the names that exist if `asked` is none of them. Names with
// consecutive numbers are one entry ("q1 to q12"). Of very many names those most similar to `asked`
// are listed, with the count of the others.
[[nodiscard]] std::string listed_names(std::string_view asked,
                                       const std::vector<std::string>& names);

}  // namespace armlet::lang
