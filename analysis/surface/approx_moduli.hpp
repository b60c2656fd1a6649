#pragma once

#include "analysis/surface/vertex_matrix.hpp"

#include <vector>

namespace limes {

/// A block at one mu and n (VertexBlock::at), for its eigenvalues in floating point, which are hints only.
class ApproxBlock {
 public:
  /// \pre the entries' coefficients are constant
  explicit ApproxBlock(const VertexBlock& block);
  /// The moduli of the eigenvalues for omega + 1/omega = 2 c, falling. \pre -1 <= c <= 1
  std::vector<double> moduli(double c) const;

 private:
  struct Entry {
    int row = 0, column = 0, exponent = 0;
    double weight = 0;
  };
  int size_;
  std::vector<Entry> entries_;
};

}  // namespace limes
