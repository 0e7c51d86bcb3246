// Objects of the world (language reference, sections 14 and 19).

#include <fmt/format.h>

#include <cmath>

#include "armlet/cell/collisions.hpp"
#include "armlet/core/format.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/host.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules.hpp"
#include "values/bind.hpp"
#include "values/values.hpp"
#include "values/world/meshes.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

// The object of a handle, the first argument; fails if it was removed.
Answer<const Object*> object_of(Vm& vm, const ObjectRef& o) {
  const Object* object = Host::of(vm).cell().world().find(o.name);
  if (object == nullptr) return fail_unknown_object(vm, o.name, CallPart::first());
  return object;
}

ShapeValue box(double x, double y, double z) { return {Box{{x, y, z}}}; }
ShapeValue cylinder(double radius, double height) { return {Cylinder{radius, height}}; }
ShapeValue sphere(double radius) { return {Sphere{radius}}; }
ShapeValue cone(double radius, double height) { return {Cone{radius, height}}; }
ShapeValue plane(double x, double y) { return {Plane{{x, y}}}; }

Answer<ObjectRef> object_named(Vm& vm, std::string_view name) {
  if (find_object(vm, name) == nullptr) return fail_unknown_object(vm, name, at("name"));
  return ObjectRef{std::string(name)};
}
std::string object_name(const ObjectRef& o) { return o.name; }

Answer<PosC> pose_of(Vm& vm, const ObjectRef& o) {
  const auto object = object_of(vm, o);
  if (!object) return Failed{};
  return PosC{(*object)->T_world_obj, has_orientation(**object)};
}

// The object of a handle. Fails if it was removed, or while a gripper holds it, since it can then
// be neither moved nor removed.
Answer<const Object*> free_object(Vm& vm, const ObjectRef& o, std::string_view what) {
  auto object = object_of(vm, o);
  if (!object) return object;
  const Cell& cell = Host::of(vm).cell();
  const auto holder = cell.holder_of(o.name);
  if (!holder) return object;
  const std::string& name = cell.robot(*holder).name;
  return failure(vm, row("R0631"),
                 fmt::format("\"{}\" is held by `{}`, so it cannot be {}", o.name, name, what),
                 CallPart::first(), {}, fmt::format("write {}.release() first", name));
}

// W0714, once in a program.
void report_falls(Vm& vm, const std::vector<Fall>& falls) {
  if (falls.empty() || !Host::of(vm).first_fall()) return;
  const Fall& first = falls.front();
  Failure advice;
  advice.headline = {row("W0714"),
                     {first.name, format_mm(first.drop.distance),
                      first.drop.support == "floor" ? std::string("the floor")
                                                    : fmt::format("\"{}\"", first.drop.support)}};
  advice.mark = CallPart::first();
  for (std::size_t i = 1; i < falls.size(); ++i)
    advice.why += fmt::format("{}\"{}\"", i == 1 ? "so did " : ", ", falls[i].name);
  vm.advise(advice);
}

Answer<void> set_pose(Vm& vm, const ObjectRef& o, const PosC& p) try {
  const auto object = free_object(vm, o, "put elsewhere");
  if (!object) return Failed{};
  Isometry3d T = p.T;
  if (!p.has_orientation) T.linear() = (*object)->T_world_obj.linear();
  report_falls(vm, Host::of(vm).cell().set_pose(o.name, T));
  report_overlap(vm, o.name);
  return {};
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}
Answer<void> remove_object(Vm& vm, const ObjectRef& o) {
  if (!free_object(vm, o, "removed")) return Failed{};
  report_falls(vm, Host::of(vm).cell().remove(o.name));
  return {};
}

std::vector<ObjectRef> objects(Vm& vm) {
  std::vector<ObjectRef> all;
  for (const std::string& name : Host::of(vm).cell().world().names()) all.push_back({name});
  return all;
}

// The movable object whose centre is nearest to a position; null if there is none.
const Object* nearest(Vm& vm, const Vector3d& p) {
  const World& world = Host::of(vm).cell().world();
  const Object* best = nullptr;
  for (std::size_t i = 0; i < world.size(); ++i) {
    const Object& object = world.object(i);
    const auto gap = [&](const Object& o) { return (o.T_world_obj.translation() - p).norm(); };
    if (!object.fixed && (best == nullptr || gap(object) < gap(*best))) best = &object;
  }
  return best;
}
bool object_at(Vm& vm, const PosC& p, double within) {
  const Object* object = nearest(vm, p.T.translation());
  return object != nullptr &&
         (object->T_world_obj.translation() - p.T.translation()).norm() <= within;
}
Answer<ObjectRef> nearest_object(Vm& vm, const PosC& p) {
  const Object* object = nearest(vm, p.T.translation());
  if (object != nullptr) return ObjectRef{object->name};
  return failure(vm, row("R0625"), "there is no object that could be grasped in this world");
}

// Two bodies with a smaller distance touch.
constexpr double kTouching = 1e-6;  // m

CellBody thing(const ObjectRef& o) { return {.object = o.name}; }
CellBody thing(const RobotRef& r) { return {.robot = r.id}; }
Answer<void> check_there(Vm&, const RobotRef&, CallPart) { return {}; }
Answer<void> check_there(Vm& vm, const ObjectRef& o, CallPart part) {
  if (Host::of(vm).cell().world().find(o.name) != nullptr) return {};
  return fail_unknown_object(vm, o.name, part);
}

template <class A, class B>
Answer<double> distance_of(Vm& vm, const A& a, const B& b) {
  if (!check_there(vm, a, CallPart::first()) || !check_there(vm, b, CallPart::operand(1)))
    return Failed{};
  return distance_between(Host::of(vm).cell(), thing(a), thing(b));
}
template <class A, class B>
Answer<RecordObj*> closest_points(Vm& vm, const A& a, const B& b) {
  if (!check_there(vm, a, CallPart::first()) || !check_there(vm, b, CallPart::operand(1)))
    return Failed{};
  const Cell& cell = Host::of(vm).cell();
  const Clearance found = nearest_between(cell, thing(a), thing(b));
  const auto point = [](const Vector3d& p) {
    return PosC{Isometry3d(Eigen::Translation3d(p)), false};
  };
  const auto name = [&](const CellBody& body) {
    return body.object.empty() ? body_text(cell, body) : body.object;
  };
  RecordObj* record = new_record(vm, vm.program().library_record("ClosestPoints"));
  if (record == nullptr) return Failed{};
  Slot* fields = record->fields();
  enum { kDistance, kFrom, kTo, kBody, kOther };
  const auto set = [&](int field, Obj* object) {
    fields[field].o = object;
    return object != nullptr;
  };
  fields[kDistance].d = found.distance;
  const bool whole = set(kFrom, new_posc(vm, point(found.p_body))) &&
                     set(kTo, new_posc(vm, point(found.p_other))) &&
                     set(kBody, new_text(vm, name(found.body))) &&
                     set(kOther, new_text(vm, name(found.other)));
  if (whole) return record;
  release(vm, record);
  return Failed{};
}
template <class A, class B>
Answer<bool> are_touching(Vm& vm, const A& a, const B& b) {
  const auto distance = distance_of(vm, a, b);
  if (!distance) return Failed{};
  return *distance <= kTouching;
}

// From above: the z axis of the tool points down, its x axis is the object's x axis rotated by yaw.
Answer<PosC> top_grasp(Vm& vm, const ObjectRef& o, double yaw) {
  const auto object = object_of(vm, o);
  if (!object) return Failed{};
  if (!std::isfinite(yaw)) return not_finite(vm, "yaw", yaw, at("yaw"));
  const Eigen::Matrix3d& R = (*object)->T_world_obj.linear();
  // The heading of a tilted object is that of its x axis, or of its y axis if its x axis is
  // vertical.
  const Vector3d axis = std::hypot(R(0, 0), R(1, 0)) > 1e-6 ? R.col(0) : R.col(1);
  const double heading = det::atan2(axis.y(), axis.x());
  const Eigen::Matrix3d R_tool = rot_z(heading + yaw) * rot_x(std::numbers::pi);
  return PosC{make_pose(renormalised(R_tool), grasp_from_above(**object)), true};
}

constexpr std::string_view kClosestHelp =
    "The distance of two things, the points of both that it lies between, and what these belong "
    "to: an object, mounted or held ones too, or a part of a robot.";

constexpr NativeFunction kWorldFunctions[] = {
    def<box>("box(x: length, y: length, z: length) -> shape",
             "A box with its edges along its own axes.", "box(40mm, 40mm, 40mm)",
             {.check = check_box}),
    def<cylinder>("cylinder(radius: length, height: length) -> shape",
                  "A cylinder standing along its own z axis.",
                  "cylinder(radius: 20mm, height: 50mm)", {.check = check_cylinder}),
    def<sphere>("sphere(radius: length) -> shape", "A sphere.", "sphere(15mm)",
                {.check = check_sphere}),
    def<cone>("cone(radius: length, height: length) -> shape",
              "A cone standing on its base; its frame is at half the height.",
              "cone(radius: 20mm, height: 50mm)", {.check = check_cylinder}),
    def<plane>("plane(x: length, y: length) -> shape",
               "A thin rectangle that faces up, its frame in the middle.", "plane(400mm, 300mm)",
               {.check = check_plane}),
    def<mesh_shape>(
        "mesh(path: string, density: density?, unit: length?, part: string?, scale: double = 1) -> "
        "shape",
        "The body whose surface is in a file of the program's folder, or in the node of it that "
        "part names: GLB, or OBJ, 3DS, VRML 2.0, STL, DAE, PLY and glTF, which are converted. Its "
        "frame is in the middle of the box around it, z up. With a density its objects have a "
        "mass; "
        "unit is the length of one unit of a file that does not say so, such as 1mm of an STL, and "
        "scale makes the body larger.",
        "mesh(\"part.glb\", density: 2700kg/m^3)"),
    def<object_named>("object(name: string) -> object", "The object of that name.",
                      "object(\"cube\")", {.check = check_object_name}),
    def<object_name>("object.name(o: object) -> string", "The name.", "object(\"cube\").name"),
    def<pose_of>("poseOf(o: object) -> posC", "The frame of an object's centre.",
                 "poseOf(object(\"cube\"))"),
    def<set_pose>(
        "setPose(o: object, p: posC)",
        "Puts an object that no hand holds somewhere else; what rested on it falls to the "
        "next surface.",
        "setPose(object(\"cube\"), xyz(300mm, 0mm, 300mm))"),
    def<remove_object>("remove(o: object)",
                       "Takes an object that no hand holds out of the world; what rested on it "
                       "falls to the next surface.",
                       "remove(object(\"cube\"))"),
    def<objects>("objects() -> object[]", "All objects of the world.", "objects()"),
    def<object_at>("objectAt(p: posC, within: length) -> bool",
                   "Whether an object that is not fixed has its centre near p.",
                   "objectAt(xyz(300mm, 0mm, 0mm), within: 20mm)"),
    def<nearest_object>("nearestObject(p: posC) -> object",
                        "The object that is not fixed and has its centre nearest to p.",
                        "nearestObject(poseOf(object(\"cube\")))"),
    def<distance_of<ObjectRef, ObjectRef>>("distance(a: object, b: object) -> length",
                                           "The gap between the surfaces of two objects; below "
                                           "zero: how far one would have to be moved "
                                           "at least until they no longer overlap; a mesh with "
                                           "hollows may have to be moved farther.",
                                           "distance(object(\"cube\"), object(\"table\"))"),
    def<distance_of<RobotRef, ObjectRef>>(
        "distance(r: robot, o: object) -> length",
        "The smallest gap between an arm, with its hand, what it holds and what is mounted on it, "
        "and an object.",
        "distance(robots.ur5(), object(\"cube\"))"),
    def<distance_of<RobotRef, RobotRef>>(
        "distance(r: robot, other: robot) -> length",
        "The smallest gap between two arms with all that they carry.",
        "distance(robots.ur5(), robots.scara(base: xyz(2000mm, 0mm, 0mm)))"),
    def<closest_points<ObjectRef, ObjectRef>>(
        "closestPoints(a: object, b: object) -> ClosestPoints", kClosestHelp,
        "print(closestPoints(object(\"cube\"), object(\"table\")).distance)"),
    def<closest_points<RobotRef, ObjectRef>>(
        "closestPoints(r: robot, o: object) -> ClosestPoints", kClosestHelp,
        "print(closestPoints(robots.ur5(), object(\"cube\")).body)"),
    def<closest_points<RobotRef, RobotRef>>(
        "closestPoints(r: robot, other: robot) -> ClosestPoints", kClosestHelp,
        "print(closestPoints(robots.ur5(), robots.scara(base: xyz(2000mm, 0mm, 0mm))).other)"),
    def<are_touching<ObjectRef, ObjectRef>>("touching(a: object, b: object) -> bool",
                                            "Whether two objects touch or overlap.",
                                            "touching(object(\"cube\"), object(\"table\"))"),
    def<are_touching<RobotRef, ObjectRef>>(
        "touching(r: robot, o: object) -> bool",
        "Whether an arm, its hand or what it carries touches an object or overlaps it.",
        "touching(robots.ur5(), object(\"cube\"))"),
    def<top_grasp>("topGrasp(o: object, yaw: angle = 0rad) -> posC",
                   "The pose for grasping an object from above, at the upper end of what is long "
                   "and stands. The fingers close along the object's own x axis, as far as that "
                   "lies flat, rotated by yaw about the vertical.",
                   "topGrasp(object(\"cube\"))"),
};

}  // namespace

std::span<const NativeFunction> world_functions() { return kWorldFunctions; }

}  // namespace armlet::bind
