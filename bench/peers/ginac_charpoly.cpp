// GiNaC's charpoly for bench/peers/characteristic_polynomial. Standard input: the size n, then n^2 entries, one a line, row by row, in
// w and gamma. Prints CPU milliseconds and the value of det(lambda I - L) at lambda = 2, w = 1/7, gamma = 3.
#include <ginac/ginac.h>

#include <ctime>
#include <iostream>
#include <string>

int main() {
  unsigned n = 0;
  std::cin >> n;
  const GiNaC::symbol lambda("lambda"), w("w"), gamma("gamma");
  GiNaC::parser reader(GiNaC::symtab{{"w", w}, {"gamma", gamma}});
  GiNaC::matrix matrix(n, n);
  for (unsigned k = 0; k < n * n; ++k) {
    std::string entry;
    std::cin >> std::ws;
    std::getline(std::cin, entry);
    matrix(k / n, k % n) = reader(entry);
  }
  const std::clock_t begin = std::clock();
  const GiNaC::ex chi = matrix.charpoly(lambda);
  const double milliseconds = 1e3 * double(std::clock() - begin) / CLOCKS_PER_SEC;
  const GiNaC::ex value = chi.subs(GiNaC::lst{lambda == 2, w == GiNaC::numeric(1, 7), gamma == 3}).normal();
  std::cout << milliseconds << " " << value << std::endl;
}
