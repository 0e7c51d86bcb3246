#include "values/formats.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "armlet/core/format.hpp"
#include "armlet/interpreter/unit.hpp"
#include "armlet/math/rotation.hpp"

namespace armlet::bind {
namespace {

// The format of lengths and angles.
class NumberStyle {
 public:
  NumberStyle(std::string_view style, std::string_view unit) : style_(style) {
    const auto given = unit.empty() ? std::nullopt : parse_unit(unit);
    if (!given) return;
    NamedUnit& meant = given->dim == dims::kLength ? length_ : angle_;
    meant = {std::string(unit), given->factor};
    given_ = {std::string(unit), given->factor};
  }

  struct NamedUnit {
    std::string name;
    double factor = 1.0;
  };
  [[nodiscard]] const NamedUnit& length() const { return length_; }
  [[nodiscard]] const NamedUnit& angle() const { return angle_; }
  [[nodiscard]] const NamedUnit& given() const { return given_; }  // no name: not given

  // The text of a number that is already in the unit.
  [[nodiscard]] std::string text(double value) const {
    const bool has_digits = style_.find_first_of(".efg") != std::string::npos;
    if (!has_digits) {
      // The fewest digits: at most one decimal as in `print`, or those of a quantity in the given
      // unit. The rest of the style is the width.
      std::string width;
      bool sign = false;
      for (const char c : style_) {
        if (c == '+') sign = true;
        if (c != '+' && !(c == '0' && width.empty())) width += c;
      }
      const std::string number =
          (sign && value >= 0.0 ? "+" : "") + format_number(value, decimals_of(value));
      return fmt::format(fmt::runtime("{:" + (aligns() ? "" : std::string(">")) + width + "}"),
                         number);
    }
    const std::string format = "{:" + style_ + "}";
    std::string out = fmt::format(fmt::runtime(format), value);
    // Zero is printed without a sign.
    const std::string_view digits = std::string_view(out).substr(0, out.find('e'));
    if (digits.find_first_of("123456789") == std::string_view::npos)
      out = fmt::format(fmt::runtime(format), 0.0);
    return out;
  }
  [[nodiscard]] std::string measure(double si, const NamedUnit& unit) const {
    const std::string number = text(si / unit.factor);
    return unit.name.empty() ? number : number + ' ' + unit.name;
  }

 private:
  // At most ten digits, of which at most nine are decimals: the others would be rounding errors.
  [[nodiscard]] int decimals_of(double value) const {
    if (given_.name.empty()) return 1;
    int decimals = 9;
    for (double size = 10.0; decimals > 0 && std::abs(value) >= size; size *= 10.0) --decimals;
    return decimals;
  }
  [[nodiscard]] bool aligns() const {
    return !style_.empty() && std::string_view("<^>").find(style_[0]) != std::string_view::npos;
  }

  std::string style_;
  NamedUnit length_{"mm", 1e-3};
  NamedUnit angle_{"deg", std::numbers::pi / 180.0};
  NamedUnit given_{"", 1.0};
};

std::string format_vector_in(const Eigen::Vector3d& v, const NumberStyle& style,
                             const NumberStyle::NamedUnit& unit) {
  return fmt::format("({}, {}, {}) {}", style.text(v[0] / unit.factor),
                     style.text(v[1] / unit.factor), style.text(v[2] / unit.factor), unit.name);
}

// The text of an orientation in a format; without one it is orientation_text.
std::string format_orientation(const Eigen::Matrix3d& R, const NumberStyle& style) {
  const Eigen::Vector3d phi = rotation_log(R);
  const double angle = phi.norm();
  if (angle < 1e-9) return style.measure(0.0, style.angle()) + " about z";
  for (int i = 0; i < 3; ++i) {
    if (std::abs(std::abs(phi[i]) - angle) < 1e-9 * std::max(1.0, angle)) {
      // A rotation by 180 deg is the same in both directions.
      const bool is_half = std::abs(angle - std::numbers::pi) < 1e-9;
      return fmt::format("{} about {}", style.measure(is_half ? angle : phi[i], style.angle()),
                         "xyz"[i]);
    }
  }
  return "rpy " + format_vector_in(rpy_from_R(R), style, style.angle());
}

}  // namespace

std::string format_posc(const PosC& p, std::string_view style, std::string_view unit) {
  const NumberStyle numbers(style, unit);
  std::string text = format_vector_in(p.T.translation(), numbers, numbers.length());
  if (p.has_orientation) text += ", " + format_orientation(p.T.linear(), numbers);
  return text;
}

std::string format_posj(const PosJ& q, std::string_view style, std::string_view unit) {
  const NumberStyle numbers(style, unit);
  std::string text = "posJ(";
  for (int i = 0; i < q.n; ++i) {
    if (i > 0) text += ", ";
    text += numbers.measure(q.q[i], !q.kinds_known ? numbers.given()
                                    : q.turns[i]   ? numbers.angle()
                                                   : numbers.length());
  }
  return text + ")";
}

}  // namespace armlet::bind
