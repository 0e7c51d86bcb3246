#include "urdf_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

namespace armlet {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

// Elements of a link or a joint whose attributes are numbers, but for the name of a joint.
constexpr std::string_view kNumeric[] = {"origin", "axis",     "mass", "inertia",
                                         "limit",  "dynamics", "mimic"};

bool are_numbers(std::string_view text) {
  int count = 0;
  for (std::size_t at = text.find_first_not_of(kBlank); at != std::string_view::npos;
       at = text.find_first_not_of(kBlank, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc() || stop != text.data() + end || !std::isfinite(value)) return false;
    ++count;
    at = end;
  }
  return count > 0;
}

struct Attribute {
  std::string_view name, value;
};

// An element's name and attributes, from the text between < and >.
struct Tag {
  std::string_view name;
  std::vector<Attribute> attributes;
};

Tag tag_of(std::string_view text) {
  Tag out;
  std::size_t at = std::min(text.find_first_of(" \t\r\n/"), text.size());
  out.name = text.substr(0, at);
  while ((at = text.find_first_not_of(kBlank, at)) != std::string_view::npos) {
    const std::size_t equals = text.find('=', at);
    if (equals == std::string_view::npos) break;
    const std::size_t open = text.find_first_of("\"'", equals);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) break;
    const std::string_view name = text.substr(at, equals - at);
    out.attributes.push_back({name.substr(0, std::min(name.find_first_of(kBlank), name.size())),
                              text.substr(open + 1, close - open - 1)});
    at = close + 1;
  }
  return out;
}

std::string_view name_of(const Tag& tag) {
  for (const Attribute& attribute : tag.attributes) {
    if (attribute.name == "name") return attribute.value;
  }
  return "";
}

std::string fault_of(const Tag& part, const Tag& tag) {
  if (std::ranges::find(kNumeric, tag.name) == std::end(kNumeric)) return {};
  for (const Attribute& attribute : tag.attributes) {
    if (attribute.name == "joint" || are_numbers(attribute.value)) continue;
    return fmt::format("{} `{}` has {}=\"{}\" in its {}; expected finite numbers", part.name,
                       name_of(part), attribute.name, attribute.value, tag.name);
  }
  return {};
}

}  // namespace

std::string number_fault(std::string_view text) {
  std::vector<Tag> open;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at + 1);
    if (rest.starts_with("!--")) {
      at = text.find("-->", at);
      if (at == std::string_view::npos) break;
      continue;
    }
    if (rest.starts_with("?") || rest.starts_with("!")) continue;
    if (rest.starts_with("/")) {
      if (!open.empty()) open.pop_back();
      continue;
    }
    const std::string_view inside = rest.substr(0, rest.find('>'));
    const Tag tag = tag_of(inside);
    // robot > link or joint > ...
    if (open.size() >= 2 && (open[1].name == "link" || open[1].name == "joint")) {
      if (std::string fault = fault_of(open[1], tag); !fault.empty()) return fault;
    }
    if (!inside.ends_with("/")) open.push_back(tag);
  }
  return {};
}

}  // namespace armlet
