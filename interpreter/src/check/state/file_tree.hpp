#pragma once
// The syntax trees of the files of a program, the input of the checker.

#include <vector>

#include "ast/ast.hpp"

namespace armlet::lang {

struct KeptFile;

// The syntax tree of one file.
struct FileTree {
  // An import and the index of its file; -1: the file was not found, which was reported.
  struct Import {
    const ast::ImportStmt* statement;
    int file;
    const KeptFile* kept = nullptr;  // set: the file as an earlier entry has read it
  };
  ast::Block program{};
  bool ok = true;  // false: statements with mistakes are missing from the tree
  std::vector<Import> imports{};
};

}  // namespace armlet::lang
