#include "svg_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/xml.hpp"

namespace armlet::svg {

std::string coordinate(double value) {
  const double rounded = std::round(value * 100.0) / 100.0;
  return fmt::format("{}", rounded == 0.0 ? 0.0 : rounded);
}

double width_of(std::string_view text, double size) {
  int letters = 0;
  for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
  return 0.58 * size * letters;
}

std::string with_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "\u2212");
  return number;
}

std::string text(Point at, std::string_view anchor, std::string_view css, std::string_view content,
                 std::string_view more) {
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" class=\"{}\"{}>{}</text>\n",
                     coordinate(at.x), coordinate(at.y), anchor, css, more, xml_escaped(content));
}

std::string line(Point from, Point to, std::string_view css) {
  return fmt::format("<path class=\"{}\" d=\"M{} {}L{} {}\"/>\n", css, coordinate(from.x),
                     coordinate(from.y), coordinate(to.x), coordinate(to.y));
}

// Series: M. Okabe and K. Ito, Color universal design, 2008, the yellow darkened. Heights: viridis
// (S. van der Walt and N. Smith 2015), whose brightness rises linearly.
std::string_view style() {
  return R"(<style>
text{font-family:system-ui,sans-serif;font-size:12px;fill:#333}
.title{font-size:15px;font-weight:600}
.panel{font-weight:600}
.note{font-size:11px;fill:#666}
.paper{fill:#fff}
.grid{stroke:#e3e3e3;fill:none}
.minor{stroke-width:.5}
.zero{stroke:#b5b5b5;fill:none}
.frame{stroke:#888;fill:none}
.s{fill:none;stroke-width:1.8;stroke-linejoin:round;stroke-linecap:round}
.dash{stroke-dasharray:1 4}
.aside{stroke-dasharray:8 5}
.s0{stroke:#0072b2}.s1{stroke:#d55e00}.s2{stroke:#009e73}.s3{stroke:#cc79a7}
.s4{stroke:#b8860b}.s5{stroke:#56b4e9}.s6{stroke:#666}
.f0{fill:#0072b2}.f1{fill:#d55e00}.f2{fill:#009e73}.f3{fill:#cc79a7}
.f4{fill:#b8860b}.f5{fill:#56b4e9}.f6{fill:#666}
.few{fill-opacity:.5}.some{fill-opacity:.75}
.h0{fill:#440154}.h1{fill:#46327e}.h2{fill:#365c8d}.h3{fill:#277f8e}
.h4{fill:#1fa187}.h5{fill:#4ac16d}.h6{fill:#a0da39}.h7{fill:#e3d31b}
@media (prefers-color-scheme:dark){
text{fill:#ddd}
.note{fill:#aaa}
.paper{fill:#1b1d21}
.grid{stroke:#34373d}
.zero{stroke:#6a6f78}
.frame{stroke:#8a8f98}
.s0{stroke:#4aa8e0}.s1{stroke:#f08a3c}.s2{stroke:#2bc597}.s3{stroke:#e2a3c7}
.s4{stroke:#e0b43a}.s5{stroke:#8fd0f5}.s6{stroke:#b5b5b5}
.f0{fill:#4aa8e0}.f1{fill:#f08a3c}.f2{fill:#2bc597}.f3{fill:#e2a3c7}
.f4{fill:#e0b43a}.f5{fill:#8fd0f5}.f6{fill:#b5b5b5}
.h0{fill:#7b4fa0}.h1{fill:#6a66b8}
}
</style>
)";
}

}  // namespace armlet::svg
