// The machine's loop, noting what it executes.

#include "executed.hpp"

#define ARMLET_NOTE_EXECUTED(op) armlet::lang::executed_opcodes().insert(op)
#include "vm/instructions/interpret.cpp"
