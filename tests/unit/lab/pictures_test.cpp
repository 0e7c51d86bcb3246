// What cameras see on the page of a laboratory.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "armlet/stdlib/install.hpp"
#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

namespace {

// A camera on an arm that goes over a card; its noise is other in each picture.
const std::string kEye = R"(robot arm = robots.scara()
camera eye { on: arm; at: xyz(z: 20mm); size: [160, 120]; fov: 60deg; noise: 3.0; ground: false }
object card { shape: box(80mm, 60mm, 5mm); at: xyz(450mm, 120mm, 2.5mm); color: "black"; fixed: true }
var found = [0, 0; 0, 0]
let wanted = [40, 30; 120, 30; 120, 90; 40, 90]
lab cell {
    view plain(of: eye)
    view truth(of: eye, overlay: "truth", wanted: wanted)
    view marked(of: eye, overlay: fn() => found)
    view looked(of: eye, overlay: fn(img) => corners(gray(img), max: 3))
    image photo(fn() => eye.capture())
    image far(fn() => eye.captureDepth())
    view broken(of: eye, overlay: fn() => [1, 2, 3;])
}
fn step(x: length) {
    arm.moveL(xyz(x, 120mm, 260mm), time: 1s)
    let img = eye.capture()
    found = [1, 2; 3, 4] * (x / 100mm)
    print(img[80, 60].r)
}
arm.moveJ(arm.ikine(xyz(400mm, 120mm, 260mm)), time: 1s)
step(420mm)
step(460mm)
step(440mm)
)";

struct SeenPage {
  explicit SeenPage(const std::string& text) : laboratory(lab_with(text)), page(laboratory) {
    page.hello();
    finish_work(laboratory);
    page.take();
  }
  // The picture of an element; null: there is an error instead.
  const TestPicture* picture(const std::string& element, double t) {
    refusal = page.ask({{"type", "picture"}, {"element", element}, {"t", t}});
    const auto found = page.pictures.find(page.last_seq());
    return found == page.pictures.end() ? nullptr : &found->second;
  }
  Laboratory laboratory;
  TestPage page;
  TestJson refusal;
};

// The same instant of the same program without a laboratory.
std::vector<std::string> printed(const std::string& text) {
  SessionOptions plain = lab_with("").session;
  std::string out;
  plain.output = [&](std::string_view piece) { out += piece; };
  Session session(library_engine(), plain);
  REQUIRE(session.compile(text, "program.rbt"));
  REQUIRE(session.run().status == Progress::kDone);
  return {out};
}

}  // namespace

TEST_CASE("the picture of a camera is drawn at the instant that is asked for") {
  SeenPage lab(kEye);
  REQUIRE(lab.page.last("diagnostics")["runs"] == true);
  REQUIRE(lab.page.last("run")["state"] == "done");
  CHECK(lab.page.last("run")["pictures"] == 3);
  const TestPicture* late = lab.picture("plain", 4.0);
  REQUIRE(late != nullptr);
  CHECK(late->width == 160);
  CHECK(late->height == 120);
  CHECK(late->channels == 3);
  const std::vector<std::uint8_t> at_end = late->pixels;
  const TestPicture* early = lab.picture("plain", 1.0);
  REQUIRE(early != nullptr);
  CHECK(early->pixels != at_end);
  CHECK(early->told["marks"].empty());
  // Backwards and forwards again it is the same picture, noise included.
  CHECK(lab.picture("plain", 4.0)->pixels == at_end);
  CHECK(lab.picture("photo", 4.0)->pixels == at_end);
}

TEST_CASE("looking at pictures changes nothing in the run") {
  SeenPage lab(kEye);
  for (const double t : {0.5, 1.0, 2.0, 2.5, 4.0})
    for (const char* each : {"plain", "photo", "looked", "far"})
      CHECK(lab.picture(each, t) != nullptr);
  // Numbers that the run printed from noisy pictures.
  std::string told;
  for (const TestJson& note : lab.page.list("notes", 1)) told += note["text"].get<std::string>();
  CHECK(std::vector<std::string>{told} == printed(kEye));
  // A run made anew from the middle is the same one, though pictures of it were looked at.
  const std::string hash = lab.page.last("run")["hash"];
  lab.page.ask({{"type", "text"}, {"text", kEye + "\n"}, {"version", 9}});
  CHECK(lab.page.last("run")["hash"] == hash);
}

TEST_CASE(
    "marks are where the truth, the wanted position and the function of the program have them") {
  SeenPage lab(kEye);
  const TestPicture* truth = lab.picture("truth", 3.0);
  REQUIRE(truth != nullptr);
  const TestJson& marks = truth->told["marks"];
  REQUIRE(marks.size() == 2);
  CHECK(marks[0]["what"] == "truth");
  CHECK(marks[0]["object"] == "card");
  // White against black: at each corner that is seen the pixels around are neither all white nor
  // all black.
  REQUIRE(marks[0]["pixels"].size() >= 2);
  for (const TestJson& pixel : marks[0]["pixels"]) {
    const int x = static_cast<int>(std::lround(pixel[0].get<double>()));
    const int y = static_cast<int>(std::lround(pixel[1].get<double>()));
    int least = 255, most = 0;
    for (int i = std::max(0, y - 3); i <= std::min(119, y + 3); ++i) {
      for (int j = std::max(0, x - 3); j <= std::min(159, x + 3); ++j) {
        const int value = truth->pixels[static_cast<std::size_t>(3 * (160 * i + j))];
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    CHECK(most - least > 40);
  }
  CHECK(marks[1]["what"] == "wanted");
  CHECK(marks[1]["pixels"] == TestJson({{40.0, 30.0}, {120.0, 30.0}, {120.0, 90.0}, {40.0, 90.0}}));
  const TestPicture* marked = lab.picture("marked", 3.5);
  REQUIRE(marked != nullptr);
  CHECK(marked->told["marks"][0]["what"] == "feature");
  CHECK(marked->told["marks"][0]["pixels"][1][0].get<double>() == doctest::Approx(13.8));
  const TestPicture* looked = lab.picture("looked", 3.5);
  REQUIRE(looked != nullptr);
  CHECK(looked->told["marks"][0]["pixels"].size() <= 3);
  CHECK(lab.picture("far", 3.5)->channels == 1);
}

TEST_CASE("what cannot be shown says why") {
  SeenPage lab(kEye);
  const TestPicture* broken = lab.picture("broken", 1.0);
  REQUIRE(broken != nullptr);
  CHECK(broken->told["fault"].get<std::string>().find("1 x 3") != std::string::npos);
  for (const TestJson& ask :
       {TestJson{{"type", "picture"}, {"element", "nothing"}, {"t", 1.0}},
        TestJson{{"type", "picture"}, {"element", "plain"}, {"t", 99.0}},
        TestJson{{"type", "picture"}, {"element", "plain"}, {"t", -1.0}},
        TestJson{{"type", "picture"}, {"element", "plain"}, {"t", 1.0}, {"run", 7}},
        TestJson{{"type", "picture"}, {"t", 1.0}},
        TestJson{{"type", "picture"}, {"element", "plain"}}}) {
    CAPTURE(ask.dump());
    CHECK(lab.page.ask(ask)["type"] == "error");
  }
}

TEST_CASE("the paths of features are read along the run, and cameras are described") {
  SeenPage lab(kEye);
  const TestJson description = lab.page.last("description");
  REQUIRE(description["cameras"].size() == 1);
  const TestJson& camera = description["cameras"][0];
  CHECK(camera["name"] == "eye");
  CHECK(camera["robot"] == 0);
  CHECK(camera["link"] == 4);
  CHECK(camera["size"] == TestJson({160, 120}));
  CHECK(camera["T"][14].get<double>() == doctest::Approx(0.02));
  CHECK(description["elements"][1]["camera"] == "eye");
  CHECK(description["elements"][1]["overlay"] == "truth");
  CHECK(description["elements"][0]["is_read"] == false);
  CHECK(description["elements"][2]["is_read"] == true);
  const std::vector<double>& way = lab.page.rows[{3, 1, 2}];
  REQUIRE(way.size() % 5 == 0);
  const std::size_t count = way.size() / 5;
  CHECK(count > 100);
  CHECK(count <= 252);
  CHECK(way[5 * (count - 1)] == doctest::Approx(4.0));
  CHECK(way[5 * (count - 1) + 4] == doctest::Approx(17.6));
  CHECK(way[1] == 0.0);
}

TEST_CASE("a look that is under way when its run becomes another one begins again") {
  // The loop takes several slices, so that an input comes in the middle of a look.
  const std::string slow = R"(robot arm = robots.scara()
camera eye { at: lookingAt(xyz(), from: xyz(z: 1m)); size: [32, 24] }
var n = 0
lab cell {
    view plain(of: eye)
    text count(fn() => f"{n}")
    button more("More", fn() { setSignal("more", true) })
}
for (i in range(400000)) { n += 1 }
wait(1s)
)";
  for (const bool is_picture : {true, false}) {
    CAPTURE(is_picture);
    SeenPage lab(slow);
    REQUIRE(lab.page.last("run")["state"] == "done");
    TestJson ask = is_picture ? TestJson{{"type", "picture"}, {"element", "plain"}}
                              : TestJson{{"type", "goto"}};
    ask["t"] = 1.0;
    ask["seq"] = 900;
    lab.page.send(ask);
    REQUIRE(lab.laboratory.advance());
    CHECK(lab.page.ask({{"type", "input"}, {"press", "more"}})["type"] == "taken");
    if (is_picture) {
      CHECK(lab.page.pictures.contains(900));
    } else {
      CHECK(lab.page.last("instant")["t"] == 1.0);
      CHECK(lab.page.last("elements")["values"].dump().find("40000") != std::string::npos);
    }
  }
}

TEST_CASE("a question for a picture of a run that is dropped is answered") {
  LaboratoryOptions options = lab_with(kEye);
  options.most_runs = 1;
  Laboratory laboratory(std::move(options));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.send({{"type", "picture"}, {"element", "plain"}, {"t", 4.0}, {"seq", 900}});
  page.ask({{"type", "text"}, {"text", "wait(1s)\n"}, {"version", 2}});
  CHECK(page.pictures.empty());
  const bool is_refused = std::ranges::any_of(page.told, [](const TestJson& each) {
    return each.value("to", 0) == 900 && each["type"] == "error";
  });
  CHECK(is_refused);
}
