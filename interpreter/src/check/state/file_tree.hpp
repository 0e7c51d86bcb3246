#pragma once
// The files of a program as the checker is given them.

#include <vector>

#include "ast/ast.hpp"

namespace armlet::lang {

struct KeptFile;

// One file of a program, as written.
struct FileTree {
  // An import and the number of the file that it names; -1: there is none, which was told.
  struct Import {
    const ast::ImportStmt* statement;
    int file;
    const KeptFile* kept = nullptr;  // the file as an earlier entry has read it
  };
  ast::Block program{};
  bool ok = true;  // false: statements with mistakes are missing
  std::vector<Import> imports{};
};

}  // namespace armlet::lang
