\\ Norms of iterated difference schemes in PARI/GP, run by uniform_norm_pari: for a symbol b = B / d with B in Z[x] the exact
\\ ||S_b^l|| = d^{-l} max_{r < 2^l} sum_j |c_{r + 2^l j}|, sum_i c_i x^i = B(x) B(x^2) ... B(x^{2^{l-1}}), in three ways.

\\ The six-point scheme at w: a = (1 + x)^{m+1} 2^{-m} b.
symbol(w, m) = {
  my(a = Pol([w, 0, -3*w - 1/16, 0, 2*w + 9/16, 1, 2*w + 9/16, 0, -3*w - 1/16, 0, w]), q = divrem(a, (1 + x)^(m + 1)));
  if (q[2] != 0, error("the factor is missing"));
  2^m * q[1]
};

\\ Sums over the residues modulo 2^l, as vector additions.
greatest_row_sum(P, l) = {
  my(c = abs(Vecrev(P)), n = 2^l, rows = ceil(#c / n));
  c = concat(c, vector(rows * n - #c));
  vecmax(sum(k = 0, rows - 1, c[k * n + 1 .. (k + 1) * n]))
};

\\ The product, factor by factor; PARI multiplies in Z[x] by Kronecker's substitution and GMP.
by_product(B, l) = { my(P = B); for(k = 1, l - 1, P *= subst(B, x, x^(2^k))); greatest_row_sum(P, l) };

\\ The same product as sums of shifted vectors, one for each coefficient of B.
by_shifts(B, l) = {
  my(b = Vecrev(B), n = #b - 1, P = b);
  for (k = 1, l - 1, my(s = 2^k); P = sum(i = 0, n, b[i + 1] * concat([vector(i * s), P, vector((n - i) * s)])));
  greatest_row_sum(Polrev(P), l)
};

\\ The columns (c_{r + 2^l j})_j of all residues r, multiplied by the two difference sections: products of integer matrices.
by_sections(B, l) = {
  my(n = poldegree(B), V = matid(n)[, 1 .. 1], section(e) = matrix(n, n, j, i, polcoef(B, e + 2*(j - 1) - (i - 1))), S = section(0), T = section(1));
  for (k = 1, l, V = concat(S * V, T * V));
  vecmax(vector(n, i, 1) * abs(V))
};

\\ Mean CPU milliseconds over at least 200 ms.
measure(name, row_sum_of, case, B, d, l) = {
  my(runs = 0, spent = 0, N);
  while (spent < 200, gettime(); N = row_sum_of(B, l); spent += gettime(); runs++);
  print(case, " ", l, " ", name, " ", strprintf("%.3f", spent / runs), " ", N / d^l)
};

{
  foreach([["six_point_c2", 1/96, 2], ["six_point_c3", 141/10000, 3]], c,
    my(b = symbol(c[2], c[3]), d = denominator(content(b)));
    foreach([10, 12, 14, 16], l,
      measure("product", by_product, c[1], d * b, d, l);
      measure("shifts", by_shifts, c[1], d * b, d, l);
      measure("sections", by_sections, c[1], d * b, d, l)))
}
