// Pictures that programs show: their figure, their pixels, and the events for listeners.

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "armlet/backend/backend.hpp"
#include "armlet/stdlib/session.hpp"
#include "library.hpp"

using namespace armlet;

namespace {

class ShownFigures : public Backend {
 public:
  void on(const Event& event) override {
    if (const auto* each = std::get_if<FinalFigure>(&event)) figures.push_back(*each->figure);
    if (std::holds_alternative<FigureChanged>(event)) ++changes;
  }
  std::vector<Figure> figures;
  int changes = 0;
};

ShownFigures shown_by(const std::string& program) {
  ShownFigures backend;
  SessionOptions options;
  options.backends = {&backend};
  Session session(library_engine(), std::move(options));
  REQUIRE(session.compile(program, "show.rbt"));
  const RunResult result = session.run();
  if (result.error) MESSAGE(result.error->message);
  REQUIRE(result.status == Progress::kDone);
  return backend;
}

// The only picture that a program shows.
Figure picture_of(const std::string& program) {
  std::vector<Figure> figures = shown_by(program).figures;
  REQUIRE(figures.size() == 1);
  REQUIRE(figures[0].picture != nullptr);
  return figures[0];
}

std::vector<int> levels_of(const Figure& figure) {
  const auto bytes = figure.picture->bytes();
  return {bytes.begin(), bytes.end()};
}

std::string error_of(const std::string& program) {
  Session session(library_engine(), SessionOptions{});
  REQUIRE(session.compile(program, "show.rbt"));
  const RunResult result = session.run();
  REQUIRE(result.error);
  return result.error->message;
}

}  // namespace

TEST_CASE("a picture becomes a figure with its pixels and a note about them") {
  const Figure figure = picture_of("show(image([0, 128; 255, 7]), \"levels\")");
  CHECK(figure.title == "levels");
  CHECK(figure.note == "2 x 2, grey");
  CHECK(levels_of(figure) == std::vector{0, 128, 255, 7});
  CHECK(picture_of("image([3;]).show()").note == "1 x 1, grey");
}

TEST_CASE("a title names the figure, and a picture replaces the one before") {
  const ShownFigures seen = shown_by(
      "for (k in range(1, 5)) { show(image([10 * k;]), \"a\") }\n"
      "show(image([50;]), \"b\")\n"
      "show(image([60;]), \"a\")\n");
  REQUIRE(seen.figures.size() == 2);
  CHECK(seen.figures[0].title == "b");
  CHECK(levels_of(seen.figures[0]) == std::vector{50});
  CHECK(levels_of(seen.figures[1]) == std::vector{60});
  CHECK(seen.changes >= 2);
}

TEST_CASE("without a title a picture goes where the last one is, or into a figure that was begun") {
  const ShownFigures seen = shown_by(
      "figure(\"eye\"); show(image([1, 9;])); show(image([2, 9;]))\n"
      "figure(\"speed\"); plot([1, 2], [3, 4]); show(image([3, 9;]))\n");
  REQUIRE(seen.figures.size() == 3);
  CHECK(seen.figures[0].title == "eye");
  CHECK(levels_of(seen.figures[0]) == std::vector{2, 9});
  CHECK(seen.figures[1].picture == nullptr);
  CHECK(seen.figures[2].title.empty());
  CHECK(levels_of(seen.figures[2]) == std::vector{3, 9});
}

TEST_CASE("depths are shown as grey levels, with what white and dark mean") {
  const std::string camera =
      "object cube { shape: box(300mm, 300mm, 100mm); at: xyz(0mm, 0mm, 50mm); fixed: true }\n"
      "camera eye { at: lookingAt(xyz(0mm, 0mm, 0mm), from: xyz(0mm, 0mm, 600mm)); size: [32, 24]; "
      "ground: false }\n";
  const Figure figure = picture_of(camera + "show(eye.captureDepth())");
  CHECK(figure.picture->kind() == PixelKind::kGrey);
  CHECK(figure.note == "32 x 24, depths: white 0.5 m, dark 0.5 m, black nothing");
  const std::vector<int> levels = levels_of(figure);
  CHECK(std::ranges::count(levels, 0) > 100);
  CHECK(std::ranges::count(levels, 255) > 100);
  const Figure none = picture_of(
      "camera eye { at: lookingAt(xyz(9m, 0mm, 9m), from: xyz(9m, 0mm, 5m)); size: [8, 6]; "
      "ground: false }\nshow(eye.captureDepth())");
  CHECK(none.note == "8 x 6, depths: nothing is seen");
  CHECK(std::ranges::all_of(levels_of(none), [](int level) { return level == 0; }));
}

TEST_CASE("the ones of a mask are white, and dark pictures stay dark") {
  const Figure mask = picture_of("show(image([0, 1; 1, 0]))");
  CHECK(levels_of(mask) == std::vector{0, 255, 255, 0});
  CHECK(mask.note == "2 x 2, grey: white 1");
  CHECK(levels_of(picture_of("show(image([0, 2; 1, 0]))")) == std::vector{0, 2, 1, 0});
  CHECK(picture_of("show(image([0, 0;]))").note == "2 x 1, grey");
}

TEST_CASE("wide pictures are reduced, the longer side to 720 pixels") {
  const Figure wide = picture_of("show(image(200 * ones(2, 4096)))");
  CHECK(wide.picture->width() == 720);
  CHECK(wide.picture->height() == 1);
  CHECK(wide.note == "4096 x 2, grey, reduced to 720 x 1");
  CHECK(std::ranges::all_of(levels_of(wide), [](int level) { return level == 200; }));
  const Figure high = picture_of("show(image(7 * ones(4096, 3072)))");
  CHECK(high.note == "3072 x 4096, grey, reduced to 540 x 720");
}

TEST_CASE("a figure shows a picture or lines, not both, and stays as it was") {
  CHECK(error_of("show(image([1;]), \"a\"); plot([1, 2], [3, 4])") ==
        "this figure shows a picture");
  CHECK(error_of("figure(\"a\"); plot([1, 2], [3, 4]); show(image([1;]), \"a\")") ==
        "the figure \"a\" shows something else than a picture");
  CHECK(error_of("show(image([1;]), \"a\"); figure(\"a\", log: \"y\")") ==
        "only an axis of numbers in the plane can be logarithmic");
  const Figure kept = picture_of(
      "show(image([9;]), \"a\")\ntry { bars([\"x\"], [1]) } catch (e) { }\n"
      "try { plot([1, 2], [3, 4]) } catch (e) { }\n");
  CHECK(levels_of(kept) == std::vector{9});
  CHECK(kept.names.empty());
}

TEST_CASE(
    "pictures of many titles do not use up the memory of the host; of one title they do not") {
  const std::string many =
      "let img = image(9 * ones(720, 720))\nvar k = 0\n"
      "while (true) { show(img, f\"picture {k}\"); k += 1 }\n";
  CHECK(error_of(many).find("at most 5000000 values") != std::string::npos);
  CHECK(shown_by(
            "let img = image(9 * ones(720, 720))\nfor (k in range(200)) { show(img, \"one\") }\n")
            .figures.size() == 1);
}
