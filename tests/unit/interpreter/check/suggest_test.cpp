#include "check/names/suggest.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>
#include <vector>

namespace armlet::lang {
namespace {

std::string best(std::string_view name, const std::vector<Candidate>& candidates,
                 const Type* wanted = nullptr) {
  const std::optional<Candidate> found = suggest(name, candidates, wanted);
  return found ? std::string(found->name) : "";
}

}  // namespace

TEST_CASE("the nearest name is suggested") {
  CHECK(best("pAbov", {{"pBelow"}, {"pAbove"}, {"pOver"}}) == "pAbove");
  CHECK(best("cub", {{"cylinder"}, {"cube"}, {"table"}}) == "cube");
  CHECK(best("Sync", {{"Asyn"}, {"Syn"}}) == "Syn");
  CHECK(best("hieght", {{"height"}}) == "height");
}

TEST_CASE("names that are too far away, or the same, are not suggested") {
  CHECK(best("velocity", {{"speed"}, {"time"}}).empty());
  CHECK(best("x", {{"y"}, {"z"}}).empty());
  CHECK(best("height", {{"height"}}).empty());
  CHECK(best("height", {}).empty());
  CHECK(best(std::string(1'000'000, 'a'), {{"a"}}).empty());
}

TEST_CASE("a name of the wanted type wins over one that is a little nearer") {
  TypePool types;
  const std::vector<Candidate> names = {{"home1", types.integer()}, {"home22", types.text()}};
  CHECK(best("home", names) == "home1");
  CHECK(best("home", names, types.text()) == "home22");
  CHECK(best("home", names, types.integer()) == "home1");
}

TEST_CASE("among equally near names the first is taken") {
  CHECK(best("poin", {{"point"}, {"poins"}}) == "point");
  CHECK(best("poin", {{"poins"}, {"point"}}) == "poins");
}

TEST_CASE("words of other languages have their counterpart") {
  CHECK(foreign_name("MoveAbsJ")->here == "moveJ");
  CHECK(foreign_name("PTP")->here == "moveJ");
  CHECK(foreign_name("LIN")->here == "moveL");
  CHECK(foreign_name("movej")->here == "moveJ");
  CHECK(foreign_name("movel")->here == "moveL");
  CHECK(foreign_name("sleep")->here == "wait");
  CHECK(foreign_name("println")->here == "print");
  CHECK(foreign_name("and")->here == "&&");
  CHECK(foreign_name("or")->here == "||");
  CHECK(foreign_name("not")->here == "!");
  CHECK(foreign_name("def")->here == "fn");
  CHECK(foreign_name("function")->here == "fn");
  CHECK(foreign_name("moveJ") == nullptr);
}

TEST_CASE("a foreign word has a counterpart or a reason") {
  for (const ForeignName& name : foreign_names()) {
    CAPTURE(name.foreign);
    CHECK((!name.here.empty() || !name.note.empty()));
  }
}

TEST_CASE("every foreign name stands in the table once") {
  std::set<std::string_view> seen;
  for (const ForeignName& name : foreign_names()) CHECK(seen.insert(name.foreign).second);
}

TEST_CASE("settings of other languages have their counterpart") {
  CHECK(foreign_setting("velocity") == "speed");
  CHECK(foreign_setting("zone") == "blend");
  CHECK(foreign_setting("speed").empty());
}

}  // namespace armlet::lang
