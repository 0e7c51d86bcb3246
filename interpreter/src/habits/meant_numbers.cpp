#include "habits/meant_numbers.hpp"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <vector>

#include "habits/formats.hpp"
#include "habits/meant.hpp"
#include "habits/pieces.hpp"

namespace armlet::lang {
namespace {

using Answer = std::optional<std::string>;

bool is_whole(std::string_view text) {
  return is_plain_number(text) && text.find('.') == std::string_view::npos;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// Removes blanks after a sign: "- 2" becomes -2.
std::string joined_sign(std::string text) {
  if (text.starts_with("- ")) text.erase(1, 1);
  return text;
}

}  // namespace

bool is_plain_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string_view::npos;
}

std::string with_unit(const std::string& value, const std::string& unit) {
  if (is_plain_number(value)) return value + unit;
  return as_factor(value) + " * 1" + unit;
}

Answer index_from_zero(const std::string& part) {
  const Line line(part);
  for (std::size_t i = 0; i < line.pieces.size(); ++i) {
    if (line.piece(i) == "end") return std::nullopt;
    if (line.piece(i) != ":") continue;
    const std::string first(line.text_of(0, i));
    const std::string rest(line.text_of(i + 1, line.pieces.size()));
    if (rest.find(':') != std::string::npos) return std::nullopt;
    const Answer from = first.empty() ? Answer("") : index_from_zero(first);
    return from ? Answer(*from + ':' + rest) : std::nullopt;
  }
  if (is_plain_number(part) && (!is_whole(part) || number(part) < 1)) return std::nullopt;
  return as_factor(part) + " - 1";
}

Answer counted_range(const std::string& part) {
  const std::vector<std::string> ends = values_of(part);
  if (ends.size() != 2) return std::nullopt;
  const bool has_fraction = (is_plain_number(ends[0]) && !is_whole(ends[0])) ||
                            (is_plain_number(ends[1]) && !is_whole(ends[1]));
  return ends[0] + ", " + ends[1] + (has_fraction ? " + 0.5" : " + 1");
}

Answer stepped_range(const std::string& part) {
  std::vector<std::string> parts = values_of(part);
  if (parts.size() != 3) return std::nullopt;
  for (std::string& one : parts) one = joined_sign(one);
  const std::string& step = parts[1];
  if (!is_plain_number(step) || number(step) == 0) return std::nullopt;
  const auto may_be_whole = [](const std::string& text) {
    return !is_plain_number(text) || is_whole(text);
  };
  std::string end = parts[2];
  if (!is_whole(step) || !may_be_whole(parts[0]) || !may_be_whole(end)) {
    end += step.starts_with('-') ? " - " + step.substr(1) + " / 2.0" : " + " + step + " / 2.0";
  } else {
    end += step.starts_with('-') ? " - 1" : " + 1";
  }
  return parts[0] + ", " + end + ", " + step;
}

Answer angle_with_word(const std::string& part) {
  const std::vector<std::string> values = values_of(part);
  if (values.size() != 2 || values[1].size() < 2) return std::nullopt;
  const std::string unit = values[1].substr(1, values[1].size() - 2);
  if (unit != "deg" && unit != "rad") return std::nullopt;
  return with_unit(values[0], unit);
}

Answer small_angle(const std::string& part) {
  const bool is_large =
      is_plain_number(part) && std::abs(number(part)) > 2 * std::numbers::pi + 0.01;
  return is_large ? std::nullopt : Answer(with_unit(part, "rad"));
}

Answer share_of_speed(const std::string& part) {
  if (!is_plain_number(part) || number(part) <= 0 || number(part) > 100) return std::nullopt;
  return number(part) == 100 ? "" : ", speed: " + part + " / 100.0";
}

}  // namespace armlet::lang
