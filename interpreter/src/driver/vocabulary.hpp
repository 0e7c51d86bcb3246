#pragma once
// The data of an Engine.

#include "armlet/interpreter/engine.hpp"
#include "vm/host/language_functions.hpp"
#include "vocabulary/registry.hpp"

struct armlet::Engine::Vocabulary final : lang::Registry {
  Vocabulary() : Registry(lang::kLanguageFunctions) {}
};
