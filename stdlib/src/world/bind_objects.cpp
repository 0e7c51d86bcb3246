// Creation of objects in the world (language reference, section 14).

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "armlet/core/format.hpp"
#include "armlet/stdlib/host.hpp"
#include "armlet/world/looks.hpp"
#include "messages/library_messages.hpp"
#include "rules/rules_settings.hpp"
#include "values/bind.hpp"
#include "values/robots/models.hpp"
#include "values/values.hpp"
#include "values/world/objects.hpp"

namespace armlet::bind {
namespace {

// The fields of a block besides the shape and the pose.
struct Fields {
  std::optional<double> mass{};
  std::optional<double> density{};
  Numbers com{};
  Inertia inertia{};
  double friction = Object{}.friction;
  double stiffness = Object{}.stiffness;
  std::string_view color = "gray";
  std::optional<std::string_view> texture{};
  bool fixed = false;
};

// Sets the mass, given directly or by the density.
Answer<void> weigh(Vm& vm, const Fields& fields, Object& object) {
  const auto& [mass, density] = std::tie(fields.mass, fields.density);
  object.mass = mass.value_or(mass_of(object.shape));
  if (!density) return {};
  if (!std::isfinite(*density) || !(*density > 0.0)) {
    return failure(vm, row("R0631"),
                   fmt::format("the density of \"{}\" is {} kg/m^3; expected more than 0",
                               object.name, *density),
                   at("density"));
  }
  const double volume = volume_of(object.shape);
  if (volume == 0.0) {
    return failure(
        vm, row("R0631"),
        fmt::format("a plane has no volume, so the density of \"{}\" gives no mass", object.name),
        at("density"), {}, "give it a mass");
  }
  if (!mass) {
    object.mass = *density * volume;
    return {};
  }
  Failure advice;
  advice.headline = {row("W0745"), {object.name}};
  advice.mark = at("density");
  advice.why = fmt::format("the density alone would give {:.4g} kg", *density * volume);
  advice.fix = "leave one of them out";
  vm.advise(advice);
  return {};
}

Answer<void> dress(Vm& vm, const Fields& fields, Object& object) {
  object.color = fields.color;
  if (!is_color(fields.color)) report_color(vm, fields.color, at("color"));
  if (!fields.texture) return {};
  constexpr std::size_t kMostBytes = 16 << 20;
  const std::string file(*fields.texture);
  const auto refuse = [&](const std::string& why) -> Answer<void> {
    Failure f;
    f.headline = {row("R0671"), {file, why}};
    f.mark = at("texture");
    return fail(vm, std::move(f));
  };
  Result<std::string> bytes = Host::of(vm).load_file(file, kMostBytes);
  if (!bytes.ok()) return refuse(bytes.error().message);
  if (const std::string fault = picture_fault(*bytes); !fault.empty()) return refuse(fault);
  object.texture = std::make_shared<const std::string>(std::move(bytes).value());
  return {};
}

Answer<Object> object_of_fields(Vm& vm, std::string_view name, const ShapeValue& shape,
                                const PosC& pose, const Fields& fields) {
  Object object;
  object.name = name;
  object.shape = shape.shape;
  object.T_world_obj = pose.T;
  object.friction = fields.friction;
  object.stiffness = fields.stiffness;
  object.fixed = fields.fixed;
  Link link;
  if (!read_com(vm, fields.com, at("com"), link)) return Failed{};
  if (fields.com) object.p_obj_com = link.com;
  object.inertia_com = fields.inertia;
  if (!weigh(vm, fields, object) || !dress(vm, fields, object)) return Failed{};
  return object;
}

Answer<ObjectRef> insert_object(Vm& vm, Object object, const Mount& on) try {
  Host& host = Host::of(vm);
  const ObjectRef made{object.name};
  if (host.is_skipped(made.name)) return made;
  if (on.base == FrameBase::kWorld) {
    host.cell().insert(std::move(object));
  } else {
    host.cell().insert(std::move(object), on);
  }
  report_overlap(vm, made.name);
  return made;
} catch (const ArgumentError& error) {
  return failure_of(vm, row("R0631"), error);
}

Answer<ObjectRef> make_object(Vm& vm, std::string_view name, const ShapeValue& shape,
                              const PosC& pose, const Fields& fields, const Mount& on = {}) {
  auto object = object_of_fields(vm, name, shape, pose, fields);
  if (!object) return Failed{};
  return insert_object(vm, *std::move(object), on);
}

template <class InertiaGiven>
Answer<ObjectRef> object_block(Vm& vm, std::string_view name, const ShapeValue& shape,
                               const PosC& pose, std::optional<double> mass,
                               std::optional<double> density, Numbers com, InertiaGiven inertia,
                               double friction, double stiffness, std::string_view color,
                               std::optional<std::string_view> texture, bool fixed) {
  const auto about_com = inertia_argument(vm, inertia, at("inertia"));
  if (!about_com) return Failed{};
  return make_object(vm, name, shape, pose,
                     {mass, density, com, *about_com, friction, stiffness, color, texture, fixed});
}
template <class On, class InertiaGiven>
Answer<ObjectRef> object_on(Vm& vm, std::string_view name, const ShapeValue& shape,
                            const PosC& pose, const On& on, std::optional<double> mass,
                            std::optional<double> density, Numbers com, InertiaGiven inertia,
                            double friction, double stiffness, std::string_view color,
                            std::optional<std::string_view> texture, bool fixed) {
  const auto about_com = inertia_argument(vm, inertia, at("inertia"));
  const auto mount = about_com ? mount_on(vm, on, at("on")) : Failed{};
  if (!mount) return Failed{};
  return make_object(vm, name, shape, pose,
                     {mass, density, com, *about_com, friction, stiffness, color, texture, fixed},
                     *mount);
}
template <class InertiaGiven>
Answer<ObjectRef> object_on_robot(Vm& vm, std::string_view name, const ShapeValue& shape,
                                  const PosC& pose, const RobotRef& on,
                                  std::optional<std::int64_t> link, std::optional<double> mass,
                                  std::optional<double> density, Numbers com, InertiaGiven inertia,
                                  double friction, double stiffness, std::string_view color,
                                  std::optional<std::string_view> texture, bool fixed) {
  const auto about_com = inertia_argument(vm, inertia, at("inertia"));
  const auto mount = about_com ? mount_on_robot(vm, on, link, at("link")) : Failed{};
  if (!mount) return Failed{};
  return make_object(vm, name, shape, pose,
                     {mass, density, com, *about_com, friction, stiffness, color, texture, fixed},
                     *mount);
}

Answer<ObjectRef> spawn(Vm& vm, const ShapeValue& s, std::string_view name, const PosC& pose,
                        std::optional<double> mass, std::string_view color) {
  return make_object(vm, name, s, pose, {.mass = mass, .color = color});
}

#define ARMLET_OBJECT_FIELDS(INERTIA)                                                      \
  "mass: mass?, density: density?, com: length[]?, inertia: " INERTIA                      \
  ", friction: double = 0.5, stiffness: force/length = 50N/mm, color: string = \"gray\", " \
  "texture: "                                                                              \
  "string?, fixed: bool = false) -> object"

constexpr std::string_view kObjectHelp =
    "Adds an object to the world; a fixed one cannot be grasped. What is pressed into it feels "
    "stiffness times the depth, and friction. On an object, a frame or a link of a robot, its "
    "flange unless told otherwise, it goes where that goes, and at is seen from there. inertia: "
    "about its centre of mass, kg m^2, as a 3 x 3 matrix or as three rows.";

// The functions for objects in the world and on a robot, object or frame, for one inertia type.
template <class InertiaGiven>
constexpr std::array<NativeFunction, 4> object_forms(const std::array<std::string_view, 4>& forms,
                                                     const std::array<std::string_view, 4>& shown) {
  return {def<object_block<InertiaGiven>>(forms[0], kObjectHelp, shown[0],
                                          {.check = check_inertia<"inertia">, .acts = true}),
          def<object_on_robot<InertiaGiven>>(forms[1], kObjectHelp, shown[1],
                                             {.check = check_inertia<"inertia">, .acts = true}),
          def<object_on<ObjectRef, InertiaGiven>>(
              forms[2], kObjectHelp, shown[2], {.check = check_inertia<"inertia">, .acts = true}),
          def<object_on<FrameRef, InertiaGiven>>(
              forms[3], kObjectHelp, shown[3], {.check = check_inertia<"inertia">, .acts = true})};
}

#define ARMLET_OBJECT_FORMS(INERTIA)                                                               \
  {                                                                                                \
    "object{}(name: string, shape: shape, at: posC, " ARMLET_OBJECT_FIELDS(INERTIA),               \
        "object{}(name: string, shape: shape, at: posC, on: robot, link: "                         \
        "int?, " ARMLET_OBJECT_FIELDS(INERTIA),                                                    \
        "object{}(name: string, shape: shape, at: posC, on: object, " ARMLET_OBJECT_FIELDS(        \
            INERTIA),                                                                              \
        "object{}(name: string, shape: shape, at: posC, on: frame, " ARMLET_OBJECT_FIELDS(INERTIA) \
  }

constexpr auto kWithRows = object_forms<NumberRows>(
    ARMLET_OBJECT_FORMS("double[][]?"),
    {"object part { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm) }",
     "robot arm = robots.ur5(); object bracket { shape: box(40mm, 20mm, 10mm); at: xyz(z: 5mm); "
     "on: arm; fixed: true }",
     "object knob { shape: sphere(5mm); at: xyz(z: 25mm); on: object(\"cube\") }",
     "frame bench { at: xyz(300mm, 200mm, 300mm) } object part { shape: sphere(15mm); at: xyz(); "
     "on: bench }"});
#define ARMLET_SHOWN_INERTIA "mass: 1kg; inertia: [1e-3, 0, 0; 0, 1e-3, 0; 0, 0, 1e-3] }"
constexpr auto kWithMatrix = object_forms<const MatrixObj&>(
    ARMLET_OBJECT_FORMS("matrix"),
    {"object part { shape: sphere(15mm); at: xyz(300mm, 0mm, 300mm); " ARMLET_SHOWN_INERTIA,
     "robot arm = robots.ur5(); object bracket { shape: box(40mm, 20mm, 10mm); at: xyz(z: 5mm); "
     "on: arm; " ARMLET_SHOWN_INERTIA,
     "object knob { shape: sphere(5mm); at: xyz(z: 25mm); on: "
     "object(\"cube\"); " ARMLET_SHOWN_INERTIA,
     "frame bench { at: xyz(300mm, 200mm, 300mm) } object part { shape: sphere(15mm); at: xyz(); "
     "on: bench; " ARMLET_SHOWN_INERTIA});

constexpr NativeFunction kObjectFunctions[] = {
    kWithRows[0],
    kWithRows[1],
    kWithRows[2],
    kWithRows[3],
    kWithMatrix[0],
    kWithMatrix[1],
    kWithMatrix[2],
    kWithMatrix[3],
    def<spawn>(
        "spawn(s: shape, name: string, at: posC, mass: mass?, color: string = \"gray\") -> object",
        "Adds an object to the world, in loops for example.",
        "sphere(15mm).spawn(\"ball\", at: xyz(300mm, 0mm, 300mm))", {.acts = true}),
};

}  // namespace

std::span<const NativeFunction> object_functions() { return kObjectFunctions; }

}  // namespace armlet::bind
