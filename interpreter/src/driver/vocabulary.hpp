#pragma once
// What an Engine keeps.

#include "armlet/interpreter/engine.hpp"
#include "vm/host/language_functions.hpp"
#include "vocabulary/registry.hpp"

struct armlet::Engine::Vocabulary final : lang::Registry {
  Vocabulary() : Registry(lang::kLanguageFunctions) {}
};
