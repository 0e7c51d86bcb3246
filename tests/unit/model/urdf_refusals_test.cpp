// What the parser of descriptions refuses, said of the joint or the link that it belongs to.

#include <doctest/doctest.h>

#include <array>
#include <string>

#include "armlet/model/urdf.hpp"

using namespace armlet;

namespace {

struct Parts {
  std::string mass = R"(<mass value="2"/>)";
  std::string inertia = R"(<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>)";
  std::string limit = R"(<limit lower="-1" upper="1" velocity="2" effort="10"/>)";
  std::string shape = R"(<box size="1 1 1"/>)";
};

// Two links on a base, of which one has the parts.
std::string description(const Parts& parts, int link) {
  std::string text = R"(<robot name="two"><link name="base"/>)";
  const std::array<std::string, 3> names = {"base", "upper", "fore"};
  for (int i = 1; i <= 2; ++i) {
    const Parts own = i == link ? parts : Parts{};
    const std::string& name = names[static_cast<std::size_t>(i)];
    text += "<link name=\"" + name + "\"><inertial>" + own.mass + own.inertia +
            "</inertial><collision><geometry>" + own.shape + "</geometry></collision></link>";
    text += "<joint name=\"to_" + name + "\" type=\"revolute\"><parent link=\"" +
            names[static_cast<std::size_t>(i - 1)] + "\"/><child link=\"" + name +
            "\"/><axis xyz=\"0 0 1\"/>" + own.limit + "</joint>";
  }
  return text + "</robot>";
}

std::string refusal(const Parts& parts, int link) {
  const Result<Mechanism> read = read_urdf(description(parts, link));
  return read.ok() ? "accepted" : read.error().message;
}

}  // namespace

TEST_CASE("what the parser refuses is said of the joint or the link it belongs to") {
  CHECK(refusal({}, 1) == "accepted");
  const std::array<std::string, 3> names = {"base", "upper", "fore"};
  for (int link = 1; link <= 2; ++link) {
    const std::string& name = names[static_cast<std::size_t>(link)];
    const std::string of_joint = "joint `to_" + name + "`: ", of_link = "link `" + name + "`: ";
    const auto says = [&](const Parts& parts, const std::string& part) {
      const std::string message = refusal(parts, link);
      CAPTURE(message);
      CHECK(message.find(part) != std::string::npos);
    };
    says({.limit = R"(<limit lower="-1" upper="1" effort="10"/>)"},
         of_joint + "joint limit: no velocity");
    says({.limit = R"(<limit lower="-1" upper="1" velocity="2"/>)"},
         of_joint + "joint limit: no effort");
    says({.mass = ""}, of_link + "Inertial element must have a mass element");
    says({.inertia = ""}, of_link + "Inertial element must have inertia element");
    says({.shape = ""}, of_link + "Geometry tag contains no child element");
    says({.shape = R"(<capsule radius="1" length="2"/>)"},
         of_link + "Unknown geometry type 'capsule'");
  }
}
