#include "armlet/control/refusals.hpp"

#include <doctest/doctest.h>

#include <set>
#include <utility>

#include "armlet/control/make_move.hpp"
#include "armlet/model/catalog.hpp"

namespace armlet {
namespace {

template <std::size_t... I>
std::vector<Refusal> one_of_each(std::index_sequence<I...>) {
  return {Refusal(std::in_place_index<I>)...};
}

}  // namespace

TEST_CASE("each refusal has a sentence of its own") {
  Cell cell;
  cell.add_robot(make_robot("scara"), "arm");
  std::set<std::string> sentences;
  std::vector<Refusal> all = one_of_each(std::make_index_sequence<std::variant_size_v<Refusal>>());
  for (Refusal& each : all) {
    if (auto* why = std::get_if<refused::Invalid>(&each)) why->sentence = "A time is negative.";
    if (auto* why = std::get_if<refused::Collides>(&each))
      why->met = {.body = {.robot = 0}, .other = {.object = "wall"}};
    MoveReport report{.refusal = each};
    report.planned.model = cell.robot(0).model;
    report.torques.beyond_numbers = "Forces exceed the range of numbers.";
    const std::string text = to_text(cell, report);
    INFO(text);
    CHECK(text.size() > 15);
    CHECK(text.back() == '.');
    sentences.insert(text);
  }
  CHECK(sentences.size() == all.size());
}

TEST_CASE("a sentence about torques has the joint, the torque and the limit with units") {
  Cell cell;
  cell.add_robot(make_robot("scara"), "arm");
  MoveReport report{.refusal = refused::TorqueExceeded{}};
  report.planned.model = cell.robot(0).model;
  report.torques.forces =
      MotionForces{.peaks = {{}, {.force = -52.25, .limit = 40.0, .t = 0.75}}, .nearest = 1};
  CHECK(to_text(cell, report) ==
        "Joint 2 would need 52.25 N m after 0.75 s; its motor gives 40 N m.");
}

}  // namespace armlet
