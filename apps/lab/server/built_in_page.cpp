// The built page, as a part of the command.

#include "server.hpp"

asm(".section .rodata\n"
    ".global armlet_page_begin\n"
    ".global armlet_page_end\n"
    "armlet_page_begin:\n"
    ".incbin \"" ARMLET_PAGE_FILE
    "\"\n"
    "armlet_page_end:\n"
    ".byte 0\n"
    ".previous\n");

extern "C" const char armlet_page_begin[];
extern "C" const char armlet_page_end[];

namespace armlet::lab {

std::string_view built_in_page() {
  return {armlet_page_begin, static_cast<std::size_t>(armlet_page_end - armlet_page_begin)};
}

}  // namespace armlet::lab
