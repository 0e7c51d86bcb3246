#include "check/state/suggest.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "armlet/core/error.hpp"
#include "vm/host/language_functions.hpp"
#include "vocabulary/foreign_names.hpp"
#include "vocabulary/registry.hpp"

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
  const Registry registry(kLanguageFunctions);
  CHECK(registry.foreign("sleep")->here == "wait");
  CHECK(registry.foreign("println")->here == "print");
  CHECK(registry.foreign("and")->here == "&&");
  CHECK(registry.foreign("not")->here == "!");
  CHECK(registry.foreign("def")->here == "fn");
  CHECK(registry.foreign("charAt")->here.empty());
  CHECK(registry.foreign("print") == nullptr);
  CHECK(registry.foreign("sleep", ForeignKind::kSetting) == nullptr);
}

TEST_CASE("a host adds rows, each word of a kind once") {
  static constexpr ForeignName kRows[] = {{"heatUp", "warm"},
                                          {"power", "watts", "", ForeignKind::kSetting}};
  Registry registry(kLanguageFunctions);
  registry.add_foreign_names(kRows);
  CHECK(registry.foreign("heatUp")->here == "warm");
  CHECK(registry.foreign("power") == nullptr);
  CHECK(registry.foreign("power", ForeignKind::kSetting)->here == "watts");
  CHECK_THROWS_AS(registry.add_foreign_names(kRows), ArgumentError);
  static constexpr ForeignName kTaken[] = {{"and", "&"}};
  CHECK_THROWS_AS(registry.add_foreign_names(kTaken), ArgumentError);
}

TEST_CASE("a foreign word has a counterpart or a reason") {
  for (const ForeignName& name : kForeignNames) {
    CAPTURE(name.foreign);
    CHECK((!name.here.empty() || !name.note.empty()));
  }
}

}  // namespace armlet::lang
