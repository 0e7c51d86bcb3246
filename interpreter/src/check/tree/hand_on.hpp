#pragma once
// Functions of the language that hand on lists with elements that are not set: they look
// themselves where they read one.

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

extern const NativeFunction kFilled;  // `new S[n]` of a struct whose fields all have defaults
extern const NativeFunction kLast;    // `xs.last`

}  // namespace armlet::lang
