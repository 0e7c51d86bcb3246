#pragma once
// Native functions of the virtual machine for statements and operators of the language.

#include "vocabulary/language_functions.hpp"

namespace armlet::lang {

extern const LanguageFunctions kLanguageFunctions;

}  // namespace armlet::lang
