#pragma once
// Includes all headers that a host usually needs: docs/embedding.md.

#include "armlet/interpreter/define.hpp"
#include "armlet/interpreter/define_type.hpp"
#include "armlet/interpreter/engine.hpp"
#include "armlet/interpreter/host/globals.hpp"
#include "armlet/interpreter/host/memory.hpp"
#include "armlet/interpreter/host/program_function.hpp"
#include "armlet/interpreter/host/tasks.hpp"
#include "armlet/interpreter/host/value.hpp"
#include "armlet/interpreter/host/watchdog.hpp"
#include "armlet/interpreter/render.hpp"
#include "armlet/interpreter/resource.hpp"
