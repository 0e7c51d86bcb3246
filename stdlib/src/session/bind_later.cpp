// Functions of the language reference without an implementation. Programs that use them are checked
// completely and then refused (E0199), so that they are valid when the function is added.

#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {
namespace {

// `feature`: what the message says is missing; empty: the name.
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
