#include "armlet/plot/svg.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <regex>

#include "armlet/core/base64.hpp"
#include "armlet/core/random.hpp"
#include "armlet/image/plain_png.hpp"

using namespace armlet;

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

std::string picture(const Figure& figure) { return to_svg({&figure, 1}); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

Figure line_figure(std::vector<double> x, std::vector<double> y) {
  Figure figure{.title = "speeds", .x = {"time", "s"}, .y = {"", "rad/s"}};
  figure.series.push_back({.label = "joint 1", .x = std::move(x), .y = std::move(y)});
  return figure;
}

// Tags closed, attributes quoted, no number that SVG cannot read.
void check_well_formed(const std::string& svg) {
  static const std::regex tag(R"(<(/?)([a-z]+)((?: [a-zA-Z-]+="[^"<>]*")*)(/?)>)");
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), tag), end; it != end; ++it, ++tags) {
    if ((*it)[4] == "/") continue;
    if ((*it)[1] == "/") {
      REQUIRE_FALSE(open.empty());
      CHECK(open.back() == (*it)[2]);
      open.pop_back();
    } else {
      open.push_back((*it)[2]);
    }
  }
  CHECK(open.empty());
  CHECK(tags == count(svg, "<"));
  for (const char* bad : {"nan", "inf", "e+", "script", "href"}) {
    CAPTURE(bad);
    const std::size_t style = svg.find("</style>");
    std::string drawn = std::regex_replace(svg.substr(style), std::regex(">[^<]*<"), "><");
    CHECK(drawn.find(bad) == std::string::npos);
  }
}

}  // namespace

TEST_CASE("a line is drawn between its axes, with units, title and legend") {
  const std::string svg = picture(line_figure({0, 1, 2}, {0, 1, 0.5}));
  check_well_formed(svg);
  CHECK(count(svg, "<path class=\"s s0\" d=\"M") == 2);  // the line and its swatch
  CHECK(count(svg, ">time (s)<") == 1);
  CHECK(count(svg, ">deg/s<") == 1);
  CHECK(count(svg, ">speeds<") == 2);  // the title of the document and of the figure
  CHECK(count(svg, ">joint 1<") == 1);
  CHECK(count(svg, "prefers-color-scheme:dark") == 1);
}

TEST_CASE("the ends of a line lie on the edges of the field and at its heights") {
  const std::string svg = picture(line_figure({0, 2}, {0, std::acos(-1.0) / 3}));
  std::smatch line, frame;
  REQUIRE(std::regex_search(
      svg, frame, std::regex("class=\"frame\" d=\"M([0-9.]+) ([0-9.]+)V([0-9.]+)H([0-9.]+)\"")));
  const std::string after = svg.substr(svg.find("class=\"frame\""));
  REQUIRE(std::regex_search(
      after, line, std::regex("class=\"s s0\" d=\"M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)\"")));
  CHECK(std::stod(line[1]) == doctest::Approx(std::stod(frame[1])));
  CHECK(std::stod(line[3]) == doctest::Approx(std::stod(frame[4])));
  CHECK(std::stod(line[2]) == doctest::Approx(std::stod(frame[3])));  // 0 deg/s at the bottom
  CHECK(std::stod(line[4]) == doctest::Approx(std::stod(frame[2])));  // 60 deg/s at the top
}

TEST_CASE("values that are not finite leave a gap and are counted") {
  const std::string svg =
      picture(line_figure({0, 1, 2, 3, 4, 5}, {0, 1, kInf, -kInf, 1, kInf - kInf}));
  check_well_formed(svg);
  CHECK(count(svg, "3 values left out") == 1);
  CHECK(count(svg, "<circle") == 1);  // a single value between gaps is a dot
}

TEST_CASE("nothing, one value, equal values and huge values make a picture") {
  const std::vector<std::vector<double>> cases = {{},
                                                  {1.0},
                                                  {5, 5, 5},
                                                  {1e300, -1e300},
                                                  {kInf},
                                                  {1e-300, 3e-300},
                                                  {1e308, -1e308},
                                                  {1e9, 1e9 + 1e-6}};
  for (const std::vector<double>& y : cases) {
    std::vector<double> x;
    for (std::size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<double>(i));
    for (const SeriesKind kind : {SeriesKind::kLine, SeriesKind::kPoints, SeriesKind::kBars}) {
      Figure figure = line_figure(x, y);
      figure.series[0].kind = kind;
      check_well_formed(picture(figure));
      Figure spatial{.x = {"x", "m"}, .y = {"y", "m"}, .z = {"z", "m"}};
      spatial.series.push_back({.kind = SeriesKind::kPoints, .x = y, .y = y, .z = y});
      check_well_formed(picture(spatial));
    }
  }
  CHECK(count(picture(line_figure({}, {})), "no values") == 1);
  check_well_formed(picture(Figure{}));
  check_well_formed(to_svg({}));
}

TEST_CASE("text of a program cannot leave its element") {
  Figure figure = line_figure({0, 1}, {0, 1});
  figure.title = "</title><script>alert(1)</script>&\x01";
  figure.series[0].label = "\"><svg onload=x>";
  const std::string svg = picture(figure);
  check_well_formed(svg);
  CHECK(svg.find("<script") == std::string::npos);
  CHECK(svg.find("<svg onload") == std::string::npos);
}

TEST_CASE("a map of lengths has one scale") {
  Figure figure{.x = {"x", "m"}, .y = {"y", "m"}};
  figure.series.push_back({.kind = SeriesKind::kPoints, .x = {0, 0.1, 0}, .y = {0, 0, 0.1}});
  const std::string svg = picture(figure);
  std::vector<std::pair<double, double>> at;
  static const std::regex circle("cx=\"([0-9.]+)\" cy=\"([0-9.]+)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it) {
    at.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
  }
  REQUIRE(at.size() == 3);
  CHECK(at[1].first - at[0].first == doctest::Approx(at[0].second - at[2].second).epsilon(0.001));
}

TEST_CASE("a hundred thousand points stay a small picture, the same every time") {
  Random random(62);
  Figure plane{.x = {"x", "m"}, .y = {"y", "m"}}, space = plane;
  space.z = {"z", "m"};
  plane.series.push_back({.kind = SeriesKind::kPoints});
  space.series.push_back({.kind = SeriesKind::kPoints});
  for (int k = 0; k < 100'000; ++k) {
    for (Series* series : {&plane.series[0], &space.series[0]}) {
      series->x.push_back(random.uniform(-1, 1));
      series->y.push_back(random.uniform(-1, 1));
    }
    space.series[0].z.push_back(random.uniform(0, 1));
  }
  for (const Figure& figure : {plane, space}) {
    const std::string svg = picture(figure);
    CHECK(svg.size() < 1'000'000);
    CHECK(count(svg, "<path class=\"grid\"") < 60);
    CHECK(svg == picture(figure));
    CHECK(count(svg, "<path class=\"") < 80);  // cells of one look are one path
  }
}

TEST_CASE("a long line keeps its peaks") {
  std::vector<double> x, y;
  for (int k = 0; k < 50'000; ++k) {
    x.push_back(k);
    y.push_back(k == 33'333 ? 1.0 : 0.0);
  }
  Figure figure = line_figure(x, y);
  figure.y.unit = "";
  const std::string svg = picture(figure);
  CHECK(svg.size() < 60'000);
  std::smatch frame;
  REQUIRE(std::regex_search(svg, frame, std::regex("class=\"frame\" d=\"M[0-9.]+ ([0-9.]+)V")));
  CHECK(svg.find(" " + frame[1].str() + "L") !=
        std::string::npos);  // the peak touches the upper edge
}

TEST_CASE("the axis on the right has its own values") {
  Figure figure = line_figure({0, 1}, {0, 1});
  figure.right = {"height", "m"};
  figure.series.push_back({.label = "high", .x = {0, 1}, .y = {0, 25}, .right = true});
  const std::string svg = picture(figure);
  check_well_formed(svg);
  CHECK(count(svg, ">height (m)<") == 1);
  CHECK(count(svg, ">high (right)<") == 1);
  CHECK(count(svg, ">25<") == 1);
  // The axis goes to 30 in the six steps of the one on the left; the line ends at 25 of it.
  CHECK(count(svg, ">30<") == 2);
  std::smatch frame;
  REQUIRE(std::regex_search(svg, frame,
                            std::regex("class=\"frame\" d=\"M[0-9.]+ ([0-9.]+)V([0-9.]+)")));
  const double top = std::stod(frame[1]), bottom = std::stod(frame[2]);
  std::smatch end;
  REQUIRE(std::regex_search(svg, end, std::regex("L[0-9.]+ ([0-9.]+)\"/>\n</g>")));
  CHECK(std::stod(end[1]) == doctest::Approx(bottom - (bottom - top) * 25 / 30).epsilon(1e-4));
}

TEST_CASE("bars stand beside each other on zero") {
  Figure figure{.x = {"joint", ""}, .y = {"torque", "Nm"}};
  for (const char* label : {"empty", "loaded"}) {
    figure.series.push_back(
        {.kind = SeriesKind::kBars, .label = label, .x = {1, 2, 3}, .y = {2, -1, 0.5}});
  }
  const std::string svg = picture(figure);
  check_well_formed(svg);
  CHECK(count(svg, "<path class=\"f0\"") == 2);
  CHECK(count(svg, "<path class=\"f1\"") == 2);
}

TEST_CASE("the eighth line differs from the first") {
  Figure figure = line_figure({0, 1}, {0, 1});
  for (int k = 0; k < 8; ++k) figure.series.push_back(figure.series[0]);
  CHECK(picture(figure).find("s s0 dash") != std::string::npos);
}

namespace {

Figure motion_figure() {
  Figure figure{.title = "motion"};
  const char* units[] = {"rad", "rad/s", "rad/s^2"};
  for (int order = 0; order < 3; ++order) {
    Figure panel{.title = order == 0   ? "position"
                          : order == 1 ? "speed"
                                       : "acceleration",
                 .x = {"time", "s"},
                 .y = {"", units[order]},
                 .right = {"", order == 0   ? "m"
                               : order == 1 ? "m/s"
                                            : "m/s^2"}};
    panel.series.push_back({.label = "joint 1", .x = {0, 2}, .y = {0, 1}});
    panel.series.push_back({.label = "joint 3", .x = {0, 2}, .y = {0, -0.1}, .right = true});
    figure.panels.push_back(panel);
  }
  return figure;
}

std::vector<std::smatch> matches(const std::string& text, const char* pattern) {
  std::vector<std::smatch> found;
  const std::regex wanted(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), wanted), end; it != end; ++it)
    found.push_back(*it);
  return found;
}

}  // namespace

TEST_CASE("panels have one width, one legend, and values of x below the last one only") {
  const std::string svg = picture(motion_figure());
  check_well_formed(svg);
  const auto frames =
      matches(svg, "class=\"frame\" d=\"M([0-9.]+) ([0-9.]+)V([0-9.]+)H([0-9.]+)\"");
  REQUIRE(frames.size() == 3);
  for (const std::smatch& frame : frames) {
    CHECK(frame[1] == frames[0][1]);
    CHECK(frame[4] == frames[0][4]);
  }
  CHECK(std::stod(frames[0][3]) < std::stod(frames[1][2]));
  for (const char* text :
       {">position<", ">speed<", ">acceleration<", ">deg<", ">deg/s<", ">deg/s\u00b2<", ">mm<",
        ">mm/s<", ">mm/s\u00b2<", ">time (s)<", ">joint 1<", ">joint 3 (right)<"}) {
    CAPTURE(text);
    CHECK(count(svg, text) == 1);
  }
  CHECK(count(svg, "class=\"s s0\"") == 4);        // three lines and the legend
  CHECK(count(svg, "class=\"s s1 aside\"") == 4);  // on the right: dashed
  CHECK(svg == picture(motion_figure()));
}

TEST_CASE("panels that show different series have legends of their own") {
  Figure figure = motion_figure();
  figure.panels[2].series[0].label = "force";
  const std::string svg = picture(figure);
  check_well_formed(svg);
  CHECK(count(svg, ">joint 1<") == 2);
  CHECK(count(svg, ">force<") == 1);
}

TEST_CASE("a logarithmic axis draws equal ratios as equal distances") {
  Figure figure{.x = {"steps", ""}, .y = {.label = "error", .log = true}};
  figure.series.push_back({.kind = SeriesKind::kPoints, .x = {1, 2, 3}, .y = {1, 1e-3, 1e-6}});
  const std::string svg = picture(figure);
  check_well_formed(svg);
  const auto at = matches(svg, "cy=\"([0-9.]+)\"");
  REQUIRE(at.size() == 3);
  CHECK(std::stod(at[1][1]) - std::stod(at[0][1]) ==
        doctest::Approx(std::stod(at[2][1]) - std::stod(at[1][1])).epsilon(0.001));
  CHECK(count(svg, ">10\u207b\u2076<") == 1);
  figure.series[0].y = {1, 0, -1};
  CHECK(count(picture(figure), "2 values left out") == 1);
  for (const SeriesKind kind : {SeriesKind::kLine, SeriesKind::kBars}) {
    for (const std::vector<double>& y :
         {std::vector<double>{}, {5}, {0}, {1e-300, 1e300}, {7, 7}}) {
      std::vector<double> x;
      for (std::size_t i = 0; i < y.size(); ++i) x.push_back(static_cast<double>(i + 1));
      figure.series[0] = {.kind = kind, .x = x, .y = y};
      figure.x.log = true;
      check_well_formed(picture(figure));
    }
  }
}

TEST_CASE("names stand below their bars, and lean where they are long") {
  Figure figure{.y = {"torque", "Nm"}, .names = {"base", "<elbow>", "wrist"}};
  figure.series.push_back({.kind = SeriesKind::kBars, .x = {0, 1, 2}, .y = {3, 2, 1}});
  std::string svg = picture(figure);
  check_well_formed(svg);
  CHECK(count(svg, ">&lt;elbow&gt;<") == 1);
  CHECK(count(svg, "rotate(-40") == 0);
  figure.names.assign(30, "a name that is much longer than its bar is wide");
  svg = picture(figure);
  check_well_formed(svg);
  CHECK(count(svg, "rotate(-40") == 30);
  CHECK(count(svg, "\u2026<") == 30);
  const auto first = matches(svg, "rotate\\(-40 ([0-9.]+) ");
  CHECK(std::stod(first[0][1]) > 0.766 * 20 * 0.58 * 12);  // its letters begin on the page
  figure.names.assign(500, "x");
  CHECK(count(picture(figure), ">x<") < 500);
}

TEST_CASE("a picture lies in the file, with its title and its note") {
  Image image(40, 30, PixelKind::kRgb);
  image.row(3)[5] = 200;
  Figure figure{.title = "seen <by> eye",
                .picture = std::make_shared<const Image>(image),
                .note = "40 x 30, RGB"};
  const std::string svg = picture(figure);
  CHECK(count(svg, "href=\"data:image/png;base64," + to_base64(plain_png(image)) + '"') == 1);
  CHECK(count(svg, ">40 x 30, RGB<") == 1);
  CHECK(count(svg, ">seen &lt;by&gt; eye<") == 2);  // of the file and above the picture
  CHECK(count(svg, "no values") == 0);
  CHECK(count(svg, "width=\"684\" height=\"513\"") == 2);  // 40 : 30 in the width of a figure
  CHECK(svg == picture(figure));
}

TEST_CASE("pictures of every size have room, one below the other") {
  std::vector<Figure> figures;
  for (const auto& [width, height] : {std::pair{1, 1}, {720, 1}, {1, 720}, {720, 720}})
    figures.push_back({.picture = std::make_shared<const Image>(width, height, PixelKind::kGrey)});
  const std::string svg = to_svg(figures);
  static const std::regex image(
      R"re(<image x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)" height="([0-9.]+)")re");
  int images = 0;
  for (std::sregex_iterator it(svg.begin(), svg.end(), image), end; it != end; ++it, ++images) {
    CHECK(std::stod((*it)[3]) >= 2.0);
    CHECK(std::stod((*it)[4]) >= 2.0);
    CHECK(std::stod((*it)[1]) + std::stod((*it)[3]) <= 720.0);
    CHECK(std::stod((*it)[4]) <= 560.0);
  }
  CHECK(images == 4);
}
