#include "vocabulary/written_call.hpp"

#include <fmt/format.h>

#include <span>
#include <string_view>
#include <vector>

namespace armlet::lang {

std::string_view block_of(std::string_view name) {
  for (const std::string_view word : {"with", "path"}) {
    if (name.starts_with(word) && name.substr(word.size()).starts_with('.')) return word;
  }
  return {};
}

std::string_view indexed(std::string_view name) { return name.substr(0, name.find_first_of(".[")); }

namespace {

// The parameters of a signature: "(a: point, b: point)" -> {"a: point", "b: point"}
std::vector<std::string_view> parameters_in(std::string_view signature) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t start = 1;
  const auto add = [&](std::size_t end) {
    const std::string_view part = signature.substr(start, end - start);
    if (!part.empty()) parts.push_back(part);
  };
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const char c = signature[i];
    if (c == '(' || c == '[' || c == '{') ++depth;
    if (c == ',' && depth == 1) {
      add(i);
      start = i + 2;
    }
    if ((c == ')' || c == ']' || c == '}') && --depth == 0) {
      add(i);
      break;
    }
  }
  return parts;
}

std::vector<std::string_view> parameter_types(std::string_view signature) {
  std::vector<std::string_view> types = parameters_in(signature);
  for (std::string_view& part : types) {
    if (const std::size_t colon = part.find(": "); colon != std::string_view::npos)
      part.remove_prefix(colon + 2);
  }
  return types;
}

std::vector<std::string_view> parameter_names(std::string_view signature) {
  std::vector<std::string_view> names = parameters_in(signature);
  for (std::string_view& part : names) part = part.substr(0, part.find(": "));
  return names;
}

std::string_view result_of(std::string_view signature) {
  const std::size_t arrow = signature.rfind(") -> ");
  return arrow == std::string_view::npos ? std::string_view{} : signature.substr(arrow + 1);
}

std::string_view parameters_of(std::string_view signature) {
  const std::size_t arrow = signature.rfind(") -> ");
  return signature.substr(1, (arrow == std::string_view::npos ? signature.size() - 1 : arrow) - 1);
}

std::string operator_call(std::string_view sign, std::string_view signature) {
  const auto types = parameter_types(signature);
  if (types.size() == 1) return fmt::format("{}{}{}", sign, types[0], result_of(signature));
  if (types.size() != 2) return fmt::format("{}{}", sign, signature);
  return fmt::format("{} {} {}{}", types[0], sign, types[1], result_of(signature));
}

}  // namespace

std::string written_call(const Registry& registry, const NativeFunction& function) {
  const std::string_view name = function.name;
  const std::string_view signature = function.signature;
  if (name.ends_with("()") || function.event != BlockEvent::kNone) return {};
  if (name.starts_with("operator")) return operator_call(name.substr(8), signature);
  if (name.ends_with('=')) {  // p.x = length, q[i] = angle
    std::string place(name.substr(0, name.size() - 1));
    if (place.ends_with("[]")) {
      const auto indexes = parameter_names(signature);
      place = fmt::format("{}[{}]", indexed(place),
                          fmt::join(std::span(indexes).subspan(1, indexes.size() - 2), ", "));
    }
    return fmt::format("{} = {}", place, parameter_types(signature).back());
  }
  if (name.ends_with("[]")) {
    const auto indexes = parameter_names(signature);
    return fmt::format("{}[{}]{}", indexed(name), fmt::join(std::span(indexes).subspan(1), ", "),
                       result_of(signature));
  }
  if (name.ends_with("[:]")) {
    const auto ends = parameter_names(signature);
    std::string ranges;
    for (std::size_t i = 1; i + 1 < ends.size(); i += 2)
      ranges += fmt::format("{}{}:{}", i == 1 ? "" : ", ", ends[i], ends[i + 1]);
    return fmt::format("{}[{}]{}", indexed(name), ranges, result_of(signature));
  }
  if (name.ends_with("{}"))
    return fmt::format("{} NAME {{ {} }}", name.substr(0, name.size() - 2),
                       parameters_of(signature));
  if (const std::string_view word = block_of(name); !word.empty())
    return fmt::format("{} {} {{ ... }}", word, signature);
  const std::size_t dot = name.find('.');
  if (dot == std::string_view::npos || registry.type(name.substr(0, dot)) == nullptr)
    return fmt::format("{}{}", name, signature);
  const std::string_view rest = name.substr(dot + 1);
  if (const std::size_t row = rest.find('.'); row != std::string_view::npos) {
    std::string_view written = parameters_of(signature);
    // The row is followed by its name.
    if (name.ends_with(kNamedRow) && written.ends_with("name: string"))
      written = written.substr(0, written.rfind(written == "name: string" ? "name" : ", name"));
    return fmt::format("{} {}({})", rest.substr(0, row), rest.substr(row + 1), written);
  }
  const std::string_view parameters = parameters_of(signature);
  const std::size_t second = parameters.find(", ");
  if (second == std::string_view::npos) return fmt::format("{}{}", name, result_of(signature));
  return fmt::format("{}({}){}", name, parameters.substr(second + 2), result_of(signature));
}

}  // namespace armlet::lang
