// Objects of the world (language reference, sections 14 and 19).

#include <fmt/format.h>

#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/math/det_math.hpp"
#include "armlet/math/pose.hpp"
#include "armlet/math/rotation.hpp"
#include "armlet/stdlib/host.hpp"
#include "bind.hpp"
#include "objects.hpp"
#include "rules.hpp"
#include "values.hpp"

namespace armlet::bind {

Failed fail_unknown_object(Vm& vm, std::string_view name, int parameter) {
  Host& host = Host::of(vm);
  const World& world = host.cell().world();
  Failure f;
  f.code = "R0625";
  f.arguments = {std::string(name)};
  f.mark_parameter = parameter;
  std::string list;
  for (const std::string& known : world.names())
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", known);
  f.why = list.empty() ? "this world is empty" : fmt::format("there are {}", list);
  if (const auto meant = world.similar_name(name))
    f.fix = fmt::format("did you mean \"{}\"?", *meant);
  return fail(vm, std::move(f));
}

const Object* find_object(Vm& vm, std::string_view name) {
  Host& host = Host::of(vm);
  if (const Object* object = host.cell().world().find(name)) return object;
  host.want_world({});
  return host.cell().world().find(name);
}

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

Obj* new_object(Vm& vm, const std::string& name) {
  return new_host_value(vm, kObject, ObjectRef{name});
}

// The object behind a handle; null with the failure set if it was removed.
const Object* object_of(Vm& vm, Slot s, int parameter) {
  const std::string& name = host_value<ObjectRef>(s).name;
  const Object* object = Host::of(vm).cell().world().find(name);
  if (object == nullptr) static_cast<void>(fail_unknown_object(vm, name, parameter));
  return object;
}

Obj* box(Vm& vm, double x, double y, double z) {
  return new_host_value(vm, kShape, ShapeValue{Box{{x, y, z}}});
}
Obj* cylinder(Vm& vm, double radius, double height) {
  return new_host_value(vm, kShape, ShapeValue{Cylinder{radius, height}});
}
Obj* sphere(Vm& vm, double radius) {
  return new_host_value(vm, kShape, ShapeValue{Sphere{radius}});
}

Signal insert_object(Vm& vm, Slot* args, Object object) try {
  Host& host = Host::of(vm);
  std::string name = object.name;
  if (!host.is_skipped(name)) host.cell().insert(std::move(object));
  return give(args, new_object(vm, name));
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0631", error);
}

// (name, shape, at, mass, friction, color, fixed)
Signal object_block(Vm& vm, Slot* args) {
  Object object;
  object.name = std::string(text_value(args[0]));
  object.shape = host_value<ShapeValue>(args[1]).shape;
  object.T_world_obj = posc(args[2]).T;
  object.mass = args[3].d;
  object.friction = args[4].d;
  object.color = std::string(text_value(args[5]));
  object.fixed = args[6].i != 0;
  return insert_object(vm, args, std::move(object));
}
// (shape, name, at, mass, color)
Signal spawn(Vm& vm, Slot* args) {
  Object object;
  object.shape = host_value<ShapeValue>(args[0]).shape;
  object.name = std::string(text_value(args[1]));
  object.T_world_obj = posc(args[2]).T;
  object.mass = args[3].d;
  object.color = std::string(text_value(args[4]));
  return insert_object(vm, args, std::move(object));
}

Answer<Obj*> object_named(Vm& vm, std::string_view given_name) {
  const std::string name(given_name);
  if (find_object(vm, name) == nullptr) return fail_unknown_object(vm, name, 0);
  return new_object(vm, name);
}
std::string object_name(const ObjectRef& o) { return o.name; }

Signal pose_of(Vm& vm, Slot* args) {
  const Object* object = object_of(vm, args[0], 0);
  if (object == nullptr) return Signal::kFail;
  return give(args,
              new_posc(vm, {object->T_world_obj, std::holds_alternative<Box>(object->shape)}));
}
// What a hand holds is neither put elsewhere nor taken away: true, and the failure is set.
bool refuse_held(Vm& vm, const Object& object, std::string_view what) {
  const Cell& cell = Host::of(vm).cell();
  const auto holder = cell.holder_of(object.name);
  if (!holder) return false;
  const std::string& name = cell.robot(*holder).name;
  static_cast<void>(
      failure(vm, "R0631",
              fmt::format("\"{}\" is held by `{}`, so it cannot be {}", object.name, name, what), 0,
              {}, fmt::format("write {}.release() first", name)));
  return true;
}

// W0714, once in a program.
void tell_of_falls(Vm& vm, const std::vector<Fall>& falls) {
  if (falls.empty() || !Host::of(vm).first_fall()) return;
  const Fall& first = falls.front();
  Failure advice;
  advice.code = "W0714";
  advice.arguments = {first.name, format_mm(first.drop.distance),
                      first.drop.support == "floor" ? std::string("the floor")
                                                    : fmt::format("\"{}\"", first.drop.support)};
  advice.mark_parameter = 0;
  for (std::size_t i = 1; i < falls.size(); ++i)
    advice.why += fmt::format("{}\"{}\"", i == 1 ? "so did " : ", ", falls[i].name);
  vm.advise(advice);
}

Signal set_pose(Vm& vm, Slot* args) try {
  const Object* object = object_of(vm, args[0], 0);
  if (object == nullptr || refuse_held(vm, *object, "put elsewhere")) return Signal::kFail;
  const PosC& p = posc(args[1]);
  Isometry3d T = p.T;
  if (!p.has_orientation) T.linear() = object->T_world_obj.linear();
  tell_of_falls(vm, Host::of(vm).cell().set_pose(object->name, T));
  return give_nothing();
} catch (const ArgumentError& error) {
  return failure_of(vm, "R0631", error);
}
Signal remove_object(Vm& vm, Slot* args) {
  const Object* object = object_of(vm, args[0], 0);
  if (object == nullptr || refuse_held(vm, *object, "removed")) return Signal::kFail;
  tell_of_falls(vm, Host::of(vm).cell().remove(std::string(object->name)));
  return give_nothing();
}

Answer<Obj*> objects(Vm& vm) {
  const std::vector<std::string> names = Host::of(vm).cell().world().names();
  ListObj* list = new_list(vm, static_cast<std::uint32_t>(names.size()), true);
  if (list == nullptr) return Failed{};
  for (std::size_t i = 0; i < names.size(); ++i) {
    list->data[i].o = new_object(vm, names[i]);
    if (list->data[i].o == nullptr) {
      release(vm, list);
      return Failed{};
    }
  }
  return list;
}

// The object that is not fixed and whose centre is nearest to a place; null if there is none.
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
Signal object_at(Vm& vm, Slot* args) {
  const Vector3d p = posc(args[0]).T.translation();
  const Object* object = nearest(vm, p);
  return give(args,
              object != nullptr && (object->T_world_obj.translation() - p).norm() <= args[1].d);
}
Answer<Obj*> nearest_object(Vm& vm, const PosC& p) {
  const Object* object = nearest(vm, p.T.translation());
  if (object == nullptr) {
    Failure f;
    f.code = "R0625";
    f.message = "there is no object that could be grasped in this world";
    return fail(vm, std::move(f));
  }
  return new_object(vm, object->name);
}

// From above: the tool's z axis points down, its x axis along the object's x axis turned by yaw.
Signal top_grasp(Vm& vm, Slot* args) {
  const Object* object = object_of(vm, args[0], 0);
  if (object == nullptr) return Signal::kFail;
  if (!std::isfinite(args[1].d)) return not_finite(vm, "yaw", args[1].d, 1);
  const Eigen::Matrix3d& R = object->T_world_obj.linear();
  // A body that lies on its side still has a heading: that of its x axis, or of its y axis if x
  // stands upright.
  const Vector3d axis = std::hypot(R(0, 0), R(1, 0)) > 1e-6 ? R.col(0) : R.col(1);
  const double heading = det::atan2(axis.y(), axis.x());
  const Eigen::Matrix3d R_tool = rot_z(heading + args[1].d) * rot_x(std::numbers::pi);
  const Vector3d p = grasp_from_above(*object);
  return give(args, new_posc(vm, {make_pose(renormalised(R_tool), p), true}));
}

constexpr NativeFunction kWorldFunctions[] = {
    def<box>("box(x: length, y: length, z: length) -> shape",
             "A box with its edges along its own axes.", "box(40mm, 40mm, 40mm)",
             {.check = check_box}),
    def<cylinder>("cylinder(radius: length, height: length) -> shape",
                  "A cylinder standing along its own z axis.",
                  "cylinder(radius: 20mm, height: 50mm)", {.check = check_cylinder}),
    def<sphere>("sphere(radius: length) -> shape", "A sphere.", "sphere(15mm)",
                {.check = check_sphere}),
    acting({"object{}",
            "(name: string, shape: shape, at: posC, mass: mass = 0kg, friction: double = 0.5, "
            "color: string = \"gray\", fixed: bool = false) -> object",
            "Adds an object to the world; a fixed one cannot be grasped.",
            "object part { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }", object_block}),
    acting({"spawn",
            "(s: shape, name: string, at: posC, mass: mass = 0kg, color: string = \"gray\") -> "
            "object",
            "Adds an object to the world, in loops for example.",
            "sphere(15mm).spawn(\"ball\", at: xyz(300mm, 0mm, 300mm))", spawn}),
    def<object_named>("object(name: string) -> object", "The object of that name.",
                      "object(\"cube\")", {.check = check_object_name}),
    def<object_name>("object.name(o: object) -> string", "The name.", "object(\"cube\").name"),
    {"poseOf", "(o: object) -> posC", "The frame of an object's centre.",
     "poseOf(object(\"cube\"))", pose_of},
    {"setPose", "(o: object, p: posC)",
     "Puts an object that no hand holds somewhere else; what rested on it falls to the next "
     "surface.",
     "setPose(object(\"cube\"), xyz(300mm, 0mm, 300mm))", set_pose},
    {"remove", "(o: object)",
     "Takes an object that no hand holds out of the world; what rested on it falls to the next "
     "surface.",
     "remove(object(\"cube\"))", remove_object},
    def<objects>("objects() -> object[]", "All objects of the world.", "objects()"),
    {"objectAt", "(p: posC, within: length) -> bool",
     "Whether an object that is not fixed has its centre near p.",
     "objectAt(xyz(300mm, 0mm, 0mm), within: 20mm)", object_at},
    def<nearest_object>("nearestObject(p: posC) -> object",
                        "The object that is not fixed and has its centre nearest to p.",
                        "nearestObject(poseOf(object(\"cube\")))"),
    {"topGrasp", "(o: object, yaw: angle = 0rad) -> posC",
     "The pose for grasping an object from above, at the upper end of what is long and stands.",
     "topGrasp(object(\"cube\"))", top_grasp},
};

}  // namespace

std::span<const NativeFunction> world_functions() { return kWorldFunctions; }

}  // namespace armlet::bind
