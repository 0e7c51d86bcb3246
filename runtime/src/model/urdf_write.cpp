#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <vector>

#include "armlet/core/files.hpp"
#include "armlet/core/xml.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/model/urdf.hpp"

namespace armlet {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The fewest digits that read back to the same bits.
std::string number(double x) { return fmt::format("{}", x == 0.0 ? 0.0 : x); }

std::string three(const Vector3d& v) {
  return fmt::format("{} {} {}", number(v.x()), number(v.y()), number(v.z()));
}

std::string origin(const Isometry3d& T) {
  const Vector3d rpy = T.linear().isIdentity(0.0) ? Vector3d::Zero() : rpy_from_R(T.linear());
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", three(T.translation()), three(rpy));
}

std::string geometry_text(const LinkSolid& solid) {
  switch (solid.kind) {
    case LinkSolidKind::kBox:
      return fmt::format("<box size=\"{}\"/>", three(solid.size));
    case LinkSolidKind::kCylinder:
      return fmt::format("<cylinder radius=\"{}\" length=\"{}\"/>", number(solid.size.x()),
                         number(solid.size.y()));
    case LinkSolidKind::kSphere:
      break;
  }
  return fmt::format("<sphere radius=\"{}\"/>", number(solid.size.x()));
}

std::string solid_text(const LinkSolid& solid) {
  std::string text;
  for (const bool is_picture : {true, false}) {
    if (solid.use == (is_picture ? LinkSolidUse::kCollision : LinkSolidUse::kPicture)) continue;
    text += fmt::format("    <{0}>{1}<geometry>{2}</geometry></{0}>\n",
                        is_picture ? "visual" : "collision", origin(solid.T_link_solid),
                        geometry_text(solid));
  }
  return text;
}

std::string link_text(const std::string& name, const Link& link) {
  const bool heavy = link.mass != 0.0 || !link.inertia.isZero(0.0);
  if (!heavy && link.mesh.empty() && link.solids.empty())
    return fmt::format("  <link name=\"{}\"/>\n", xml_escaped(name));
  std::string text = fmt::format("  <link name=\"{}\">\n", xml_escaped(name));
  if (heavy) {
    const Eigen::Matrix3d& I = link.inertia;
    text += fmt::format(
        "    <inertial>\n      <origin xyz=\"{}\" rpy=\"0 0 0\"/>\n      <mass value=\"{}\"/>\n"
        "      <inertia ixx=\"{}\" ixy=\"{}\" ixz=\"{}\" iyy=\"{}\" iyz=\"{}\" izz=\"{}\"/>\n    "
        "</inertial>\n",
        three(link.com), number(link.mass), number(I(0, 0)), number(I(0, 1)), number(I(0, 2)),
        number(I(1, 1)), number(I(1, 2)), number(I(2, 2)));
  }
  if (!link.mesh.empty()) {
    text += fmt::format("    <visual><geometry><mesh filename=\"{}\"/></geometry></visual>\n",
                        xml_escaped(link.mesh));
  }
  for (const LinkSolid& each : link.solids) text += solid_text(each);
  return text + "  </link>\n";
}

// The only actuator of a joint: value = ratio q_a + shift.
struct Drive {
  Eigen::Index actuator = -1;
  double ratio = 0.0, shift = 0.0;
};

Drive drive_of(const Mechanism& m, int joint) {
  Drive drive{.shift = m.spec().offset[joint]};
  for (Eigen::Index a = 0; a < m.spec().coupling.cols(); ++a) {
    const double ratio = m.spec().coupling(joint, a);
    if (ratio == 0.0) continue;
    if (drive.actuator >= 0) {
      const Body& body =
          m.bodies()[static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(joint)])];
      throw ArgumentError(
          fmt::format("Joint `{}` of `{}` is driven by several actuators, which a URDF cannot say; "
                      "give each joint one.",
                      body.joint_name, m.name()));
    }
    drive.actuator = a;
    drive.ratio = ratio;
  }
  return drive;
}

// Joint limits from those of the actuator: the first joint that it drives represents it. Its mimic
// joints may have limits of their own.
std::string limit_text(const Mechanism& m, const Drive& drive, const Body& body) {
  if (drive.actuator < 0) {
    return fmt::format("    <limit lower=\"{0}\" upper=\"{0}\" effort=\"0\" velocity=\"0\"/>\n",
                       number(drive.shift));
  }
  const Actuator& a = m.actuators()[static_cast<std::size_t>(drive.actuator)];
  if (body.copy_limits)
    return fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n",
                       number(body.copy_limits->lower), number(body.copy_limits->upper),
                       number(a.max_effort / std::abs(drive.ratio)),
                       number(body.copy_limits->max_speed));
  const double one = drive.ratio * a.lower + drive.shift,
               other = drive.ratio * a.upper + drive.shift;
  if (is_no_limit(a.lower, a.upper))
    return fmt::format("    <limit effort=\"{}\" velocity=\"{}\"/>\n",
                       number(a.max_effort / std::abs(drive.ratio)),
                       number(a.max_speed * std::abs(drive.ratio)));
  return fmt::format("    <limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>\n",
                     number(std::min(one, other)), number(std::max(one, other)),
                     number(a.max_effort / std::abs(drive.ratio)),
                     number(a.max_speed * std::abs(drive.ratio)));
}

// The joints that represent the actuators, -1: none yet.
class Leaders {
 public:
  explicit Leaders(const Mechanism& m) : leader_(m.actuators().size(), -1) {
    for (int j = 0; j < m.joint_count(); ++j) {
      const Eigen::Index a = drive_of(m, j).actuator;
      if (a >= 0 && leader_[static_cast<std::size_t>(a)] < 0)
        leader_[static_cast<std::size_t>(a)] = j;
    }
  }
  int of(Eigen::Index actuator) const { return leader_[static_cast<std::size_t>(actuator)]; }

 private:
  std::vector<int> leader_;
};

// A joint without an actuator becomes a mimic joint of the first actuator with a factor of 0.
std::string mimic_text(const Mechanism& m, const Leaders& leaders, int joint) {
  const Drive drive = drive_of(m, joint);
  if (m.actuator_count() == 0) return {};
  const int leader = leaders.of(std::max<Eigen::Index>(drive.actuator, 0));
  if (leader < 0 || leader == joint) return {};
  const Drive lead = drive_of(m, leader);
  const double ratio = drive.ratio / lead.ratio;
  const Body& body =
      m.bodies()[static_cast<std::size_t>(m.moving()[static_cast<std::size_t>(leader)])];
  return fmt::format("    <mimic joint=\"{}\" multiplier=\"{}\" offset=\"{}\"/>\n",
                     xml_escaped(body.joint_name), number(ratio),
                     number(drive.shift - ratio * lead.shift));
}

bool is_continuous(const Mechanism& m, int joint, const Body& body) {
  const Drive drive = drive_of(m, joint);
  if (drive.actuator < 0 || body.joint != BodyJoint::kRevolute) return false;
  const Actuator& a = m.actuators()[static_cast<std::size_t>(drive.actuator)];
  return is_no_limit(a.lower, a.upper);
}

// The data of a motor and of friction that a URDF cannot express.
std::string lost_text(const Link& link) {
  std::vector<std::string> lost;
  const double gear = std::abs(link.gear);
  if (link.motor_inertia != 0.0)
    lost.push_back(fmt::format("the rotor's inertia, {} kg m^2 at the joint",
                               number(gear * gear * link.motor_inertia)));
  const Friction& f = link.friction;
  if (f.coulomb_plus != -f.coulomb_minus)
    lost.push_back(
        fmt::format("friction of {} and {} N m in the two directions: their mean stands here",
                    number(gear * f.coulomb_plus), number(gear * f.coulomb_minus)));
  if (f.stribeck_speed != 0.0)
    lost.push_back(fmt::format("static friction of {} N m", number(gear * f.static_torque)));
  if (lost.empty()) return {};
  return fmt::format("    <!-- not in a URDF: {} -->\n", fmt::join(lost, "; "));
}

std::string joint_text(const Mechanism& m, const Leaders& leaders, std::size_t i) {
  const Body& body = m.bodies()[i];
  const int joint = m.joint_of(static_cast<int>(i));
  const char* type = body.joint == BodyJoint::kFixed      ? "fixed"
                     : is_continuous(m, joint, body)      ? "continuous"
                     : body.joint == BodyJoint::kRevolute ? "revolute"
                                                          : "prismatic";
  const std::string& parent =
      body.parent < 0 ? m.spec().base_name : m.bodies()[static_cast<std::size_t>(body.parent)].name;
  std::string text = fmt::format(
      "  <joint name=\"{}\" type=\"{}\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n    "
      "{}\n",
      xml_escaped(body.joint_name), type, xml_escaped(parent), xml_escaped(body.name),
      origin(body.T_parent_joint));
  if (joint >= 0) {
    const Friction& f = body.link.friction;
    const double gear = std::abs(body.link.gear);
    text += fmt::format("    <axis xyz=\"{}\"/>\n", three(body.axis));
    text += limit_text(m, drive_of(m, joint), body);
    text += lost_text(body.link);
    const double damping = gear * gear * f.viscous,
                 dry = gear * 0.5 * (f.coulomb_plus - f.coulomb_minus);
    if (damping != 0.0 || dry != 0.0) {
      text += fmt::format("    <dynamics damping=\"{}\" friction=\"{}\"/>\n", number(damping),
                          number(dry));
    }
    text += mimic_text(m, leaders, joint);
  }
  return text + "  </joint>\n";
}

}  // namespace

std::string write_urdf(const Mechanism& m) {
  const Leaders leaders(m);
  std::string text =
      fmt::format("<?xml version=\"1.0\"?>\n<robot name=\"{}\">\n", xml_escaped(m.name()));
  text += link_text(m.spec().base_name, m.spec().base);
  for (std::size_t i = 0; i < m.bodies().size(); ++i) {
    text += link_text(m.bodies()[i].name, m.bodies()[i].link);
    text += joint_text(m, leaders, i);
  }
  for (const Tip& tip : m.tips()) {
    const std::string& parent =
        tip.body < 0 ? m.spec().base_name : m.bodies()[static_cast<std::size_t>(tip.body)].name;
    text += fmt::format(
        "  <link name=\"{0}\"/>\n  <joint name=\"{0}_fixed\" type=\"fixed\">\n    <parent "
        "link=\"{1}\"/>\n"
        "    <child link=\"{0}\"/>\n    {2}\n  </joint>\n",
        xml_escaped(tip.name), xml_escaped(parent), origin(tip.T_body_tip));
  }
  return text + "</robot>\n";
}

// The file of a package outside of the folders around the URDF.
static std::string in_packages(const PackageFolders& packages, const std::string& package,
                               const std::string& file) {
  namespace fs = std::filesystem;
  const auto if_file = [](const fs::path& path) {
    const std::string real = real_path(path.string());
    return is_file(real) ? real : std::string();
  };
  if (const auto named = packages.named.find(package); named != packages.named.end())
    return if_file(fs::path(named->second) / file);
  for (const std::string& each : packages.folders) {
    const fs::path folder = real_path(each);
    if (std::string found = if_file(folder / package / file); !found.empty()) return found;
    if (folder.filename() != package) continue;
    if (std::string found = if_file(folder / file); !found.empty()) return found;
  }
  return {};
}

std::string find_mesh(const std::string& urdf_folder, const std::string& top,
                      const std::string& name, const PackageFolders& packages) {
  namespace fs = std::filesystem;
  const fs::path limit = top.empty() ? fs::path() : fs::path(real_path(top));
  const auto exists = [&](const fs::path& path) -> std::string {
    const fs::path real = real_path(path.string());
    if (!limit.empty()) {
      const fs::path below = real.lexically_relative(limit);
      if (below.empty() || *below.begin() == "..") return {};
    }
    return is_file(real.string()) ? real.string() : std::string();
  };
  constexpr std::string_view kPackage = "package://", kFile = "file://";
  const fs::path folder = real_path(urdf_folder.empty() ? "." : urdf_folder);
  if (name.starts_with(kFile)) return exists(folder / name.substr(kFile.size()));
  if (!name.starts_with(kPackage)) return exists(folder / name);
  const std::string inside = name.substr(kPackage.size());
  const std::size_t slash = inside.find('/');
  if (slash == std::string::npos) return {};
  if (std::string found = in_packages(packages, inside.substr(0, slash), inside.substr(slash + 1));
      !found.empty())
    return found;
  for (fs::path at = folder;; at = at.parent_path()) {
    if (std::string found = exists(at / inside); !found.empty()) return found;
    if (at.filename() == inside.substr(0, slash)) {
      if (std::string found = exists(at / inside.substr(slash + 1)); !found.empty()) return found;
    }
    if (at == limit || !at.has_relative_path()) return {};
  }
}

}  // namespace armlet
