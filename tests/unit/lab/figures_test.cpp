// Figures of a run, as pages receive them.

#include <doctest/doctest.h>

#include <map>
#include <string>

#include "lab_support.hpp"

using namespace armlet;
using namespace armlet::lab;

TEST_CASE(
    "a figure in the plane has its values, and one that a plot cannot show its picture alone") {
  Laboratory laboratory(lab_with(R"(figure("speeds")
plot([0s, 1s, 2s], [0deg, 30deg, 90deg], label: "a")
plot([0s, 2s], [0mm, 50mm], label: "b", axis: "right")
figure("cloud")
scatter3([[100mm, 0mm, 50mm], [0mm, 100mm, 80mm]])
figure("bars")
bars(["x", "y"], [1.0, 2.0])
)"));
  TestPage page(laboratory);
  page.hello();
  finish_work(laboratory);
  page.take();
  std::map<std::string, TestJson> figures;
  for (const TestJson& each : page.told) {
    if (each["type"] == "figures") figures[each["title"]] = each;
  }
  REQUIRE(figures.size() == 3);
  for (const auto& [title, each] : figures) CHECK(each["svg"].get<std::string>().size() > 100);
  CHECK_FALSE(figures["cloud"].contains("panels"));
  CHECK_FALSE(figures["bars"].contains("panels"));
  const TestJson& panel = figures["speeds"].at("panels").at(0);
  CHECK(panel["x"]["unit"] == "s");
  CHECK(panel["y"]["unit"] == "rad");
  CHECK(panel["right"]["unit"] == "m");
  REQUIRE(panel["series"].size() == 2);
  CHECK(panel["series"][0]["label"] == "a");
  CHECK(panel["series"][0]["x"] == TestJson{0.0, 1.0, 2.0});
  CHECK(panel["series"][0]["y"][1].get<double>() == doctest::Approx(0.5235987755982988));
  CHECK(panel["series"][1]["right"] == true);
  CHECK(panel["series"][1]["y"] == TestJson{0.0, 0.05});
}
