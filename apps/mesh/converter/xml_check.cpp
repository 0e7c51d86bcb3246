// DAE, looked at before Assimp reads it: Assimp follows references without asking whether they come
// back to where they began, and calls itself for each element.

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "armlet/core/error.hpp"
#include "converter/file_checks.hpp"

namespace armlet::mesh {
namespace {

constexpr std::size_t kDeepest = 64;
// What Assimp reads without asking whether it is there.
constexpr std::pair<std::string_view, const char*> kNeeded[] = {
    {"float_array", "id"},        {"float_array", "count"}, {"accessor", "source"},
    {"accessor", "count"},        {"input", "semantic"},    {"input", "source"},
    {"geometry", "id"},           {"vertices", "id"},       {"newparam", "sid"},
    {"instance_geometry", "url"}, {"instance_node", "url"}, {"instance_material", "target"},
    {"instance_effect", "url"},   {"visual_scene", "id"},   {"instance_visual_scene", "url"},
    {"material", "id"},           {"effect", "id"},         {"image", "id"},
    {"triangles", "count"},       {"polylist", "count"},    {"polygons", "count"}};
constexpr double kMostNodes = 1e6;  // each as often as it is used

[[noreturn]] void refuse(const std::string& why) { throw ArgumentError(why); }

// A tag: <name attributes>, </name> or <name attributes/>.
struct Tag {
  std::string_view name;
  std::string_view attributes;
  std::size_t end = 0;  // behind it
  bool closes = false;
  bool is_empty = false;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The tag that begins at a <. An attribute in quotes may hold a >.
Tag tag_at(std::string_view text, std::size_t at) {
  char quote = 0;
  std::size_t end = at + 1;
  for (; end < text.size(); ++end) {
    const char c = text[end];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      break;
    }
  }
  if (end >= text.size()) refuse("it is cut off in an element");
  Tag tag;
  std::string_view inner = text.substr(at + 1, end - at - 1);
  tag.closes = inner.starts_with('/');
  tag.is_empty = inner.ends_with('/');
  if (tag.closes) inner.remove_prefix(1);
  std::size_t length = 0;
  while (length < inner.size() && !is_space(inner[length]) && inner[length] != '/') ++length;
  tag.name = inner.substr(0, length);
  tag.attributes = inner.substr(length);
  tag.end = end + 1;
  return tag;
}

bool is_name(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == ':';
  });
}

// A name, and attributes with their values in quotes. Assimp takes what it needs of them as given.
void check_tag(const Tag& tag) {
  const auto wrong = [&] { refuse(fmt::format("an element <{:.40}> is no XML", tag.name)); };
  if (!is_name(tag.name)) wrong();
  std::string_view rest = tag.attributes;
  const auto skip_spaces = [&] {
    while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  };
  for (skip_spaces(); !rest.empty() && rest != "/"; skip_spaces()) {
    const std::size_t end = std::min(rest.find_first_of("= \t\r\n"), rest.size());
    if (!is_name(rest.substr(0, end))) wrong();
    rest.remove_prefix(end);
    skip_spaces();
    if (!rest.starts_with('=')) wrong();
    rest.remove_prefix(1);
    skip_spaces();
    if (!rest.starts_with('"') && !rest.starts_with('\'')) wrong();
    const std::size_t close = rest.find(rest.front(), 1);
    if (close == std::string_view::npos) wrong();
    rest.remove_prefix(close + 1);
  }
}

// The value of an attribute; empty if it is not there.
std::string attribute(const Tag& tag, std::string_view name) {
  const std::string_view all = tag.attributes;
  for (std::size_t at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
    if (at == 0 || !is_space(all[at - 1])) continue;
    std::size_t next = at + name.size();
    while (next < all.size() && is_space(all[next])) ++next;
    if (next >= all.size() || all[next] != '=') continue;
    ++next;
    while (next < all.size() && is_space(all[next])) ++next;
    if (next >= all.size()) return {};
    const std::size_t end = all.find(all[next], next + 1);
    return std::string(all.substr(next + 1, std::min(end, all.size()) - next - 1));
  }
  return {};
}

// Things that name others: none may come back to itself, and what the first ones show, each as
// often as it is named, is bounded.
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

// One pass over the tags.
class DaeCheck {
 public:
  explicit DaeCheck(std::string_view text) : text_(text) {}

  void check() {
    for (std::size_t at = text_.find('<'); at != std::string_view::npos; at = text_.find('<', at)) {
      const std::string_view rest = text_.substr(at);
      if (rest.starts_with("<!--")) {
        at = past("-->", at);
      } else if (rest.starts_with("<![CDATA[")) {
        at = past("]]>", at);
      } else if (rest.starts_with("<?")) {
        at = past("?>", at);
      } else if (rest.starts_with("<!")) {
        refuse("it declares entities, which are not read");
      } else {
        const Tag tag = tag_at(text_, at);
        look(tag);
        at = tag.end;
      }
    }
    if (!open_.empty())
      refuse(fmt::format("it is cut off: {} elements are not closed", open_.size()));
    nodes_.check("node");
    controllers_.check("controller");
  }

 private:
  std::size_t past(std::string_view end, std::size_t at) const {
    const std::size_t found = text_.find(end, at);
    if (found == std::string_view::npos) refuse("it is cut off in an element");
    return found + end.size();
  }

  void look(const Tag& tag) {
    if (tag.name.find("include") != std::string_view::npos)
      refuse("it includes another file, which is not read");
    check_tag(tag);
    if (tag.closes) {
      if (open_.empty() || open_.back() != tag.name)
        refuse(fmt::format("</{:.40}> closes another element", tag.name));
      open_.pop_back();
      if (tag.name == "node" && !open_nodes_.empty()) open_nodes_.pop_back();
      if (tag.name == "effect") end_effect();
      if (tag.name == "newparam") parameter_ = -1;
      return;
    }
    if (!tag.is_empty) open_.push_back(tag.name);
    if (open_.size() > kDeepest)
      refuse(fmt::format("it has more than {} elements in one another", kDeepest));
    for (const auto& [name, key] : kNeeded) {
      if (tag.name == name && attribute(tag, key).empty())
        refuse(fmt::format("an element <{}> has no `{}`", name, key));
    }
    look_at_nodes(tag);
    look_at_parameters(tag);
    if (tag.name == "p" || tag.name == "vcount" || tag.name == "float_array") look_at_numbers(tag);
  }

  void look_at_nodes(const Tag& tag) {
    if (tag.name == "node") {
      const int node = nodes_.add();
      for (const char* const key : {"id", "name", "sid"}) nodes_.name(node, attribute(tag, key));
      if (!open_nodes_.empty()) nodes_.contains(open_nodes_.back(), node);
      if (!tag.is_empty) open_nodes_.push_back(node);
    } else if (tag.name == "instance_node" && !open_nodes_.empty()) {
      nodes_.uses(open_nodes_.back(), without_hash(attribute(tag, "url")));
    } else if (tag.name == "controller") {
      controller_ = controllers_.add();
      controllers_.name(controller_, attribute(tag, "id"));
    } else if ((tag.name == "skin" || tag.name == "morph") && controller_ >= 0) {
      controllers_.uses(controller_, without_hash(attribute(tag, "source")));
    }
  }

  // Of an effect: a sampler names a surface, which names a picture.
  void look_at_parameters(const Tag& tag) {
    if (tag.name == "newparam") {
      parameter_ = parameters_.add();
      parameters_.name(parameter_, attribute(tag, "sid"));
    } else if (parameter_ >= 0 && (tag.name == "source" || tag.name == "init_from")) {
      const std::size_t end = std::min(text_.find('<', tag.end), text_.size());
      std::string_view name = text_.substr(tag.end, end - tag.end);
      while (!name.empty() && is_space(name.front())) name.remove_prefix(1);
      while (!name.empty() && is_space(name.back())) name.remove_suffix(1);
      parameters_.uses(parameter_, std::string(name));
    } else if (parameter_ >= 0 && tag.name == "instance_image") {
      parameters_.uses(parameter_, without_hash(attribute(tag, "url")));
    }
  }

  void end_effect() {
    parameters_.check("parameter");
    parameters_ = {};
    parameter_ = -1;
  }

  // Assimp takes what is below zero for zero, and does not come past what is no number.
  void look_at_numbers(const Tag& tag) const {
    const bool whole = tag.name != "float_array";
    const std::string_view allowed = whole ? "0123456789 \t\r\n" : "0123456789 \t\r\n+-.eENaIiNnFf";
    const std::size_t end = std::min(text_.find('<', tag.end), text_.size());
    const std::string_view numbers = text_.substr(tag.end, end - tag.end);
    const std::size_t wrong = numbers.find_first_not_of(allowed);
    if (wrong == std::string_view::npos || tag.is_empty) return;
    if (whole && numbers[wrong] == '-')
      refuse(fmt::format("a list of indices, <{}>, has one below 0", tag.name));
    refuse(fmt::format("a list of numbers, <{}>, has something else in it", tag.name));
  }

  std::string_view text_;
  std::vector<std::string_view> open_;
  References nodes_, controllers_, parameters_;
  std::vector<int> open_nodes_;
  int controller_ = -1;
  int parameter_ = -1;
};

}  // namespace

void check_dae(std::string_view text) { DaeCheck(text).check(); }

}  // namespace armlet::mesh
