// Settings that take one of a few words: a word that is none of them is refused before the run,
// wherever a function of the library has such a setting.
#include "values/setting_words.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "armlet/stdlib/session.hpp"
#include "library.hpp"
#include "values/bind.hpp"

using namespace armlet;

namespace {

// Parameters that take any text, or one that is looked up: names of planners (E0202), of objects
// (E0203), of layouts and coordinates (E0530), of units and of settings of `with` (E0513).
const std::set<std::string> kOtherTexts = {
    "a",       "allow",   "as",    "b",      "collisions", "color",  "file",    "figure",
    "header",  "kind",    "label", "layout", "mesh",       "name",   "names",   "note",
    "overlay", "part",    "path",  "s",      "t",          "text",   "texture", "tip",
    "title",   "torques", "track", "traj",   "types",      "unit",   "value",   "watch",
    "xs",      "of",      "group", "limits", "style",      "columns"};

struct TextParameter {
  const NativeFunction* function;
  std::string name;
  bool is_required;
};

std::vector<TextParameter> text_parameters() {
  static const std::regex parameter(R"((\w+): string(\[\])*(\?| = )?)");
  std::vector<TextParameter> out;
  for (const bind::Chapter& chapter : bind::chapters()) {
    for (const NativeFunction& function : chapter.functions) {
      const std::string signature(function.signature);
      // What stands in braces are the fields of a record.
      const std::string given = std::regex_replace(signature.substr(signature.find('(')),
                                                   std::regex(R"(<S>\{[^}]*\})"), "");
      for (std::sregex_iterator at(given.begin(), given.end(), parameter), end; at != end; ++at)
        out.push_back({&function, (*at)[1], (*at)[3].length() == 0});
    }
  }
  return out;
}

// The example of a function with one more setting; empty if its call is not found in it.
std::string with_setting(const NativeFunction& function, const std::string& setting) {
  std::string text(function.example);
  const std::string name(function.name);
  if (name.ends_with("{}")) {
    const std::size_t brace = text.find('{');
    return brace == std::string::npos ? "" : text.insert(brace + 1, ' ' + setting + ';');
  }
  const std::string called = name.substr(name.rfind('.') + 1) + '(';
  std::size_t at = text.find(called);
  if (at == std::string::npos) return "";
  int depth = 0;
  for (at += called.size() - 1; at < text.size(); ++at) {
    if (text[at] == '(') ++depth;
    if (text[at] == ')' && --depth == 0) return text.insert(at, ", " + setting);
  }
  return "";
}

std::vector<std::string> codes_of(std::string program) {
  if (program.starts_with("joint ")) program = "robot one { " + program + " }";
  Session session(library_engine(), at_the_table());
  static_cast<void>(session.compile(program + '\n', "cell.rbt"));
  std::vector<std::string> out;
  for (const Problem& problem : session.problems()) out.push_back(problem.diagnostic.code);
  return out;
}

}  // namespace

TEST_CASE("every text that a function takes is one of a few words, or known to be free") {
  for (const TextParameter& parameter : text_parameters()) {
    CAPTURE(parameter.function->signature);
    CAPTURE(parameter.name);
    const bool has_words = !bind::words_of_parameter(parameter.name).empty();
    CHECK(has_words != kOtherTexts.contains(parameter.name));
  }
}

TEST_CASE("a word that a setting does not take is refused before the run, with each function") {
  int tried = 0;
  for (const TextParameter& parameter : text_parameters()) {
    const auto words = bind::words_of_parameter(parameter.name);
    if (words.empty() || parameter.is_required) continue;
    const std::string wrong =
        with_setting(*parameter.function, parameter.name + ": \"" + std::string(words[0]) + "x\"");
    CAPTURE(parameter.function->signature);
    CAPTURE(wrong);
    if (std::string(parameter.function->example).find(parameter.name + ":") != std::string::npos)
      continue;
    REQUIRE_FALSE(wrong.empty());
    const std::vector<std::string> codes = codes_of(wrong);
    CHECK(std::ranges::find(codes, "E0534") != codes.end());
    ++tried;
  }
  CHECK(tried > 20);
}
