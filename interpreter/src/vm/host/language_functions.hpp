#pragma once
// The functions of the machine for what the language says without a name of the library.

#include "vocabulary/language_functions.hpp"

namespace armlet::lang {

extern const LanguageFunctions kLanguageFunctions;

}  // namespace armlet::lang
