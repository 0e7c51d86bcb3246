// Functions of the language reference that nothing stands behind yet. Programs that use them are
// checked whole and then refused (E0199), so that they are right on the day the function arrives.

#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// `feature` is what the message says is missing; without it, the name.
constexpr NativeFunction later(std::string_view name, std::string_view signature,
                               std::string_view feature = {}) {
  return {.name = name, .signature = signature, .help = feature, .later = true};
}

constexpr NativeFunction kLaterFunctions[] = {
    // pictures
    later("show", "(img: image)"),
};

}  // namespace

std::span<const NativeFunction> later_functions() { return kLaterFunctions; }

}  // namespace armlet::bind
