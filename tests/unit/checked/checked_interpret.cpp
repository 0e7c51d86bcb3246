// The machine with the costly checks of what hosts do: replaces the library's.

#define ARMLET_CHECKED
#include "vm/host/host_calls.cpp"
#include "vm/instructions/interpret.cpp"
