// Checks DAE before Assimp reads it: Assimp follows references without a check for loops, and
// recurses for each element.

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "armlet/core/error.hpp"
#include "converter/file_checks.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

using tinyxml2::XMLElement;

constexpr int kDeepestElement = 64;
// Attributes that Assimp reads without a check that they exist.
constexpr std::pair<std::string_view, const char*> kNeeded[] = {
    {"float_array", "id"},        {"float_array", "count"}, {"accessor", "source"},
    {"accessor", "count"},        {"input", "semantic"},    {"input", "source"},
    {"geometry", "id"},           {"vertices", "id"},       {"newparam", "sid"},
    {"instance_geometry", "url"}, {"instance_node", "url"}, {"instance_material", "target"},
    {"instance_effect", "url"},   {"visual_scene", "id"},   {"instance_visual_scene", "url"},
    {"material", "id"},           {"effect", "id"},         {"image", "id"},
    {"triangles", "count"},       {"polylist", "count"},    {"polygons", "count"}};
constexpr double kMostNodes = 1e6;  // each counted as often as it is used

constexpr std::string_view kBlank = " \t\r\n";

// The value of an attribute; empty if it does not exist.
std::string attribute(const XMLElement& element, const char* name) {
  const char* const value = element.Attribute(name);
  return value == nullptr ? std::string() : value;
}

std::string_view text_of(const XMLElement& element) {
  const char* const text = element.GetText();
  return text == nullptr ? std::string_view() : text;
}

// Elements that refer to others: references may not form a loop, and the number of nodes shown,
// each counted as often as it is used, is bounded.
class References {
 public:
  int add() {
    to_.emplace_back();
    return static_cast<int>(to_.size()) - 1;
  }
  void name(int thing, const std::string& name) {
    if (!name.empty()) named_[name].insert(thing);
  }
  void contains(int thing, int other) {
    to_[static_cast<std::size_t>(thing)].things.push_back(other);
  }
  void uses(int thing, std::string name) {
    to_[static_cast<std::size_t>(thing)].names.push_back(std::move(name));
  }

  void check(const char* what) const {
    std::vector<double> counted(to_.size(), 0.0);  // 0: not yet; -1: being counted
    double all = 0.0;
    for (std::size_t i = 0; i < to_.size(); ++i) all += count(i, counted, what, 0);
    if (all > kMostNodes * 100) refuse(fmt::format("its {}s name one another too often", what));
  }

 private:
  struct To {
    std::vector<int> things;
    std::vector<std::string> names;
  };

  double count(std::size_t thing, std::vector<double>& counted, const char* what, int depth) const {
    if (counted[thing] > 0.0) return counted[thing];
    if (counted[thing] < 0.0) refuse(fmt::format("a {} contains itself by its references", what));
    if (depth > 1000) refuse(fmt::format("its {}s name one another more than 1000 deep", what));
    counted[thing] = -1.0;
    double sum = 1.0;
    for (const int each : to_[thing].things)
      sum += count(static_cast<std::size_t>(each), counted, what, depth + 1);
    for (const std::string& each : to_[thing].names) {
      const auto found = named_.find(each);
      if (found == named_.end()) continue;
      for (const int other : found->second)
        sum += count(static_cast<std::size_t>(other), counted, what, depth + 1);
    }
    if (sum > kMostNodes) refuse(fmt::format("its {}s show more than a million parts", what));
    return counted[thing] = sum;
  }

  std::vector<To> to_;
  std::map<std::string, std::set<int>> named_;
};

std::string without_hash(std::string name) {
  if (name.starts_with('#')) name.erase(0, 1);
  return name;
}

class DaeCheck {
 public:
  void check(std::string_view text) {
    tinyxml2::XMLDocument document;
    const tinyxml2::XMLError error = document.Parse(text.data(), text.size());
    if (error == tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED) refuse_depth();
    if (error != tinyxml2::XML_SUCCESS)
      refuse(fmt::format("line {} is no XML, or it is cut off there", document.ErrorLineNum()));
    look_into(document, 0, -1);
    nodes_.check("node");
    controllers_.check("controller");
  }

 private:
  [[noreturn]] static void refuse_depth() {
    refuse(fmt::format("it has more than {} elements in one another", kDeepestElement));
  }

  // node  the enclosing node; -1: none.
  void look_into(const tinyxml2::XMLNode& parent, int depth, int node) {
    if (depth > kDeepestElement) refuse_depth();
    for (const auto* each = parent.FirstChild(); each != nullptr; each = each->NextSibling()) {
      if (each->ToUnknown() != nullptr) refuse("it declares entities, which are not read");
      if (const XMLElement* element = each->ToElement()) look(*element, depth, node);
    }
  }

  void look(const XMLElement& element, int depth, int node) {
    const std::string_view name = element.Name();
    if (name.find("include") != std::string_view::npos)
      refuse("it includes another file, which is not read");
    for (const auto& [needing, key] : kNeeded) {
      if (name == needing && attribute(element, key).empty())
        refuse(fmt::format("an element <{}> has no `{}`", name, key));
    }
    if (name == "node") node = add_node(element, node);
    if (name == "newparam") {
      parameter_ = parameters_.add();
      parameters_.name(parameter_, attribute(element, "sid"));
    }
    look_at_references(element, name, node);
    if (name == "p" || name == "vcount" || name == "float_array") look_at_numbers(element, name);
    look_into(element, depth + 1, node);
    if (name == "newparam" || name == "effect") parameter_ = -1;
    if (name == "effect") {
      parameters_.check("parameter");
      parameters_ = {};
    }
  }

  int add_node(const XMLElement& element, int parent) {
    const int node = nodes_.add();
    for (const char* const key : {"id", "name", "sid"}) nodes_.name(node, attribute(element, key));
    if (parent >= 0) nodes_.contains(parent, node);
    return node;
  }

  // In an effect, a sampler refers to a surface, which refers to a picture.
  void look_at_references(const XMLElement& element, std::string_view name, int node) {
    if (name == "instance_node" && node >= 0) {
      nodes_.uses(node, without_hash(attribute(element, "url")));
    } else if (name == "controller") {
      controller_ = controllers_.add();
      controllers_.name(controller_, attribute(element, "id"));
    } else if ((name == "skin" || name == "morph") && controller_ >= 0) {
      controllers_.uses(controller_, without_hash(attribute(element, "source")));
    } else if (parameter_ >= 0 && (name == "source" || name == "init_from")) {
      std::string_view used = text_of(element);
      used.remove_prefix(std::min(used.find_first_not_of(kBlank), used.size()));
      used = used.substr(0, used.find_last_not_of(kBlank) + 1);
      parameters_.uses(parameter_, std::string(used));
    } else if (parameter_ >= 0 && name == "instance_image") {
      parameters_.uses(parameter_, without_hash(attribute(element, "url")));
    }
  }

  // Assimp reads negative counts as zero, and fails at text that is not a number.
  static void look_at_numbers(const XMLElement& element, std::string_view name) {
    const bool whole = name != "float_array";
    const std::string_view allowed = whole ? "0123456789 \t\r\n" : "0123456789 \t\r\n+-.eENaIiNnFf";
    const std::string_view numbers = text_of(element);
    const std::size_t wrong = numbers.find_first_not_of(allowed);
    if (wrong == std::string_view::npos) return;
    if (whole && numbers[wrong] == '-')
      refuse(fmt::format("a list of indices, <{}>, has one below 0", name));
    refuse(fmt::format("a list of numbers, <{}>, has something else in it", name));
  }

  References nodes_, controllers_, parameters_;
  int controller_ = -1;
  int parameter_ = -1;
};

}  // namespace

void check_dae(std::string_view text) { DaeCheck().check(text); }

}  // namespace armlet::mesh
