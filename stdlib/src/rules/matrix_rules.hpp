#pragma once
// Rules of matrices checked before the run: E0305, and the sizes of results known from the text.

#include "armlet/interpreter/native.hpp"

namespace armlet::bind {

void check_product(CheckCall& call);           // A * B, A * v
void check_solve(CheckCall& call);             // A \ B, A \ b
void check_sum(CheckCall& call);               // A + B and other operations element by element
void check_same_size(CheckCall& call);         // the result has the size of the only matrix
void check_square(CheckCall& call);            // needs a square matrix, returns one
void check_square_to_number(CheckCall& call);  // needs a square matrix
void check_transposed(CheckCall& call);
void check_filled(CheckCall& call);       // zeros(r, c)
void check_filled_list(CheckCall& call);  // zeros(n)
void check_identity(CheckCall& call);     // eye(n)
void check_diagonal(CheckCall& call);     // diag(v)
void check_outer(CheckCall& call);

}  // namespace armlet::bind
