#pragma once
// Replaces ANTLR's header of the same name. clang rejects a constructor in ANTLR 4.9 that g++
// accepts: the const members of Vocabulary have no initialisers, so its default constructor is
// deleted. This header gives them initialisers.

#ifdef __clang__
#define _literalNames \
  _literalNames {}
#define _symbolicNames \
  _symbolicNames {}
#define _displayNames \
  _displayNames {}
#include <Vocabulary.h>
#undef _literalNames
#undef _symbolicNames
#undef _displayNames
#endif

#include_next <antlr4-runtime.h>
