#include "urdf_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <vector>

#include "armlet/model/mechanism.hpp"
#include "xml_guard.hpp"

namespace armlet {
namespace {

constexpr std::string_view kBlank = " \t\r\n";

// Elements of a link or a joint whose attributes are numbers, except the name of a joint.
constexpr std::string_view kNumeric[] = {"origin", "axis",     "mass", "inertia",
                                         "limit",  "dynamics", "mimic"};

bool are_numbers(std::string_view text) {
  int count = 0;
  for (std::size_t at = text.find_first_not_of(kBlank); at != std::string_view::npos;
       at = text.find_first_not_of(kBlank, at)) {
    const std::size_t end = std::min(text.find_first_of(kBlank, at), text.size());
    double value = 0.0;
    const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, value);
    if (error != std::errc() || stop != text.data() + end || !std::isfinite(value)) return false;
    ++count;
    at = end;
  }
  return count > 0;
}

struct Attribute {
  std::string_view name, value;
};

// An element's name and attributes, from the text between < and >.
struct Tag {
  std::string_view name;
  std::vector<Attribute> attributes;
};

Tag tag_of(std::string_view text) {
  Tag out;
  std::size_t at = std::min(text.find_first_of(" \t\r\n/"), text.size());
  out.name = text.substr(0, at);
  while ((at = text.find_first_not_of(kBlank, at)) != std::string_view::npos) {
    const std::size_t equals = text.find('=', at);
    if (equals == std::string_view::npos) break;
    const std::size_t open = text.find_first_of("\"'", equals);
    if (open == std::string_view::npos) break;
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) break;
    const std::string_view name = text.substr(at, equals - at);
    out.attributes.push_back({name.substr(0, std::min(name.find_first_of(kBlank), name.size())),
                              text.substr(open + 1, close - open - 1)});
    at = close + 1;
  }
  return out;
}

std::string_view value_of(const Tag& tag, std::string_view attribute) {
  const auto found = std::ranges::find(tag.attributes, attribute, &Attribute::name);
  return found == tag.attributes.end() ? std::string_view{} : found->value;
}

// Calls visit(open, tag) for every element until it returns true; `open` are the enclosing elements
// from <robot> inwards.
template <class Visit>
void for_each_element(std::string_view text, Visit visit) {
  std::vector<Tag> open;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = after_xml(text, at, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = after_xml(text, at, "]]>");
    } else if (rest.starts_with("</")) {
      if (!open.empty()) open.pop_back();
      ++at;
    } else if (rest.starts_with("<?")) {
      ++at;
    } else {
      const std::size_t end = after_xml_tag(text, at);
      const std::string_view inside = text.substr(at + 1, end - at - 2);
      const Tag tag = tag_of(inside);
      if (visit(open, tag)) return;
      if (!inside.ends_with('/')) open.push_back(tag);
      at = end;
    }
  }
}

struct JointEnds {
  std::string_view name, parent, child;
};

// Checked first, since the library builds every link and joint before they can be counted.
std::string too_many(std::string_view text) {
  constexpr std::size_t kMost = Mechanism::kMaxBodies;
  std::size_t links = 0, joints = 0;
  for_each_element(text, [&](const std::vector<Tag>& open, const Tag& tag) {
    if (open.size() == 1) links += tag.name == "link" ? 1 : 0;
    if (open.size() == 1) joints += tag.name == "joint" ? 1 : 0;
    return false;
  });
  if (links > kMost + 1)  // and the base
    return fmt::format("the description has {} links; at most {} are read", links, kMost + 1);
  if (joints > kMost)
    return fmt::format("the description has {} joints; at most {} are read", joints, kMost);
  return {};
}

std::vector<JointEnds> joints_of(std::string_view text) {
  std::vector<JointEnds> joints;
  for_each_element(text, [&](const std::vector<Tag>& open, const Tag& tag) {
    if (open.size() == 1 && tag.name == "joint") joints.push_back({value_of(tag, "name"), {}, {}});
    if (open.size() == 2 && open[1].name == "joint") {
      if (tag.name == "parent") joints.back().parent = value_of(tag, "link");
      if (tag.name == "child") joints.back().child = value_of(tag, "link");
    }
    return false;
  });
  std::erase_if(joints, [](const JointEnds& j) { return j.parent.empty() || j.child.empty(); });
  return joints;
}

using JointOfChild = std::map<std::string_view, const JointEnds*>;

// The first links that form a circle of parents; empty if there are none.
std::vector<std::string_view> circle(const std::vector<JointEnds>& joints,
                                     const JointOfChild& joint_of) {
  std::map<std::string_view, std::size_t> seen;  // and from which joint it was reached
  for (std::size_t number = 0; number < joints.size(); ++number) {
    std::vector<std::string_view> way;
    for (std::string_view at = joints[number].child;; at = joint_of.at(at)->parent) {
      const auto [before, is_new] = seen.emplace(at, number);
      if (!is_new && before->second == number) {
        way.erase(way.begin(), std::ranges::find(way, at));
        return way;
      }
      if (!is_new || !joint_of.contains(at)) break;
      way.push_back(at);
    }
  }
  return {};
}

std::string fault_of(const Tag& part, const Tag& tag) {
  if (std::ranges::find(kNumeric, tag.name) == std::end(kNumeric)) return {};
  for (const Attribute& attribute : tag.attributes) {
    if (attribute.name == "joint" || are_numbers(attribute.value)) continue;
    return fmt::format("{} `{}` has {}=\"{}\" in its {}; expected finite numbers", part.name,
                       value_of(part, "name"), attribute.name, attribute.value, tag.name);
  }
  return {};
}

}  // namespace

std::string structure_fault(std::string_view text) {
  if (std::string fault = too_many(text); !fault.empty()) return fault;
  const std::vector<JointEnds> joints = joints_of(text);
  JointOfChild joint_of;
  for (const JointEnds& joint : joints) {
    if (joint.parent == joint.child) {
      return fmt::format("link `{}` is its own parent (joint `{}`)", joint.child, joint.name);
    }
    const auto [other, is_new] = joint_of.emplace(joint.child, &joint);
    if (!is_new) {
      return fmt::format("link `{}` hangs on two joints, `{}` and `{}`; every link has one parent",
                         joint.child, other->second->name, joint.name);
    }
  }
  const std::vector<std::string_view> links = circle(joints, joint_of);
  if (links.empty()) return {};
  constexpr std::size_t kMostNamed = 6;
  std::string names;
  for (std::size_t i = 0; i < std::min(links.size(), kMostNamed); ++i)
    names += fmt::format("{}`{}`", i == 0 ? "" : ", ", links[i]);
  if (links.size() > kMostNamed) names += fmt::format(" and {} more", links.size() - kMostNamed);
  return fmt::format(
      "the links {} hang on one another in a circle; one link carries all others and hangs on none",
      names);
}

std::string xacro_fault(std::string_view text) {
  std::string fault;
  for_each_element(text, [&](const std::vector<Tag>&, const Tag& tag) {
    if (tag.name.starts_with("xacro:"))
      fault = fmt::format(
          "the element <{}> belongs to a xacro file, from which a description is made first: "
          "xacro arm.urdf.xacro > arm.urdf",
          tag.name);
    return !fault.empty();
  });
  return fault;
}

std::string number_fault(std::string_view text) {
  std::string fault;
  for_each_element(text, [&](const std::vector<Tag>& open, const Tag& tag) {
    // robot > link or joint > ...
    if (open.size() >= 2 && (open[1].name == "link" || open[1].name == "joint"))
      fault = fault_of(open[1], tag);
    return !fault.empty();
  });
  return fault;
}

}  // namespace armlet
