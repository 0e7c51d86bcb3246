// The machine with the costly checks of what hosts do: takes the place of the library's.

#define ARMLET_CHECKED
#include "../../../interpreter/src/vm/host_calls.cpp"
#include "../../../interpreter/src/vm/interpret.cpp"
