#include "vocabulary/parameter_index.hpp"

#include <algorithm>
#include <cstddef>

namespace armlet::lang {

int parameter_index(std::string_view signature, std::string_view name) {
  int index = 0;
  int depth = 0;
  bool is_text = false;
  std::size_t begin = 0;  // of the parameter that is read
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const char c = signature[i];
    if (c == '"') is_text = !is_text;
    if (is_text) continue;
    const bool opens = c == '(' || c == '[' || c == '{';
    const bool closes = c == ')' || c == ']' || c == '}';
    if (opens && ++depth == 1) begin = i + 1;
    if (c == ':' && depth == 1) {
      std::string_view found = signature.substr(begin, i - begin);
      found.remove_prefix(std::min(found.find_first_not_of(' '), found.size()));
      if (found == name) return index;
    }
    if (c == ',' && depth == 1) {
      ++index;
      begin = i + 1;
    }
    if (closes && --depth == 0) return -1;
  }
  return -1;
}

}  // namespace armlet::lang
