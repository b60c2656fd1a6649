// The theorems that verdicts use, as a report states them; docs/theory.md has the proofs.
#include "reports/proof/sections_impl.hpp"

namespace limes::report_impl {
namespace {

Statement theorem(const std::string& name, const std::string& sources, Blocks body) {
  return {.kind = Statement::Kind::theorem, .title = rich("Theorem " + name + sources), .body = std::move(body), .label = "theorem-" + name};
}

Blocks conventions(bool knots) {
  Blocks blocks;
  blocks.push_back(paragraph(
      "The mask $a$ of a scheme of arity $p$ defines $(S_af)_i=\\sum_j a_{i-pj}f_j$; its symbol is $a(z)=\\sum_i a_iz^i$, and "
      "$\\sigma(z)=1+z+\\dots+z^{p-1}$. The scheme is $C^m$ if for all bounded data it converges uniformly to an $m$ times continuously "
      "differentiable function of the parameter $p^{-k}i$. The norm of $l$ steps is"));
  blocks.push_back(Display{{{"", {"\\lVert S_b^l\\rVert_\\infty=\\max_{0\\le i<p^l}\\sum_j\\bigl|b^{[l]}_{i-p^lj}\\bigr|,\\qquad b^{[l]}(z)=b(z)\\,b(z^p)\\cdots b(z^{p^{l-1}})."}}}});
  blocks.push_back(paragraph(
      "On a region of parameters a statement holds at every real parameter value. There, norms and signs are bounded by Bernstein coefficients on boxes that "
      "cover the region; all computations are exact, and so are decimals in regions. Every proof is written down as a certificate, which an independent program (`limes-check`) "
      "has verified from the scheme's definition alone."));
  if (knots) {
    blocks.push_back(paragraph(
        "A non-uniform scheme inserts points at the midpoints of knot intervals. It is $C^m$ if for every strictly increasing bi-infinite or periodic knot "
        "sequence and all data the limit is $m$ times continuously differentiable in the knots' parameter. After finitely many steps every knot with a ratio "
        "$\\gamma=(t_{i+1}-t_i)/(t_i-t_{i-1})\\ne1$ is isolated; $L(\\gamma)$ is the matrix of one step about it."));
  }
  return blocks;
}

}  // namespace

Blocks theorem_statements(const std::set<Theorem>& theorems, bool exponents) {
  Blocks blocks = conventions(theorems.contains(Theorem::n1) || theorems.contains(Theorem::n3));
  if (theorems.contains(Theorem::u1) || theorems.contains(Theorem::n1) || theorems.contains(Theorem::s1) || theorems.contains(Theorem::e1) || theorems.contains(Theorem::e2)) {
    blocks.push_back(theorem("U1", " [@Dyn1992], [@DynLevin2002]",
                             {paragraph("If $a(1)=p$, $a(z)=\\sigma(z)^{m+1}p^{-m}\\,b(z)$ with a Laurent polynomial $b$, and $\\lVert S_b^l\\rVert_\\infty<1$ for some $l\\ge1$, then the "
                                        "scheme is $C^m$. Instead of a small $\\lVert S_b^l\\rVert_\\infty$ any norm will do in which all finite sections $(B_e)_{ij}=b_{e+pj-i}$, $e=0,\\dots,p-1$, "
                                        "are contractions, such as one with a polytope as its unit ball.")}));
  }
  if (theorems.contains(Theorem::u2)) {
    blocks.push_back(theorem("U2", " [@CavarettaDahmenMicchelli1991], [@DynLevin2002]",
                             {paragraph("Let the integer shifts of the basic limit function be stable. If the scheme is $C^m$, then $a(1)=p$, $\\sigma^{m+1}$ divides $a$, and every product of the "
                                        "sections $(B_e)_{ij}=b_{e+pj-i}$, $e=0,\\dots,p-1$, of $b=p^m a/\\sigma^{m+1}$ has a spectral radius below $1$.")}));
  }
  if (exponents) {
    blocks.push_back(theorem("U3", " [@Rioul1992], [@DynLevin2002], [@GuglielmiProtasov2013]",
                             {paragraph("The Hölder exponent is the supremum of $m+\\alpha$, $0\\le\\alpha\\le1$, such that all limits have $m$ derivatives, the last one with exponent $\\alpha$. Let $a(1)=p$ and "
                                        "$a(z)=p^{1-k}\\sigma(z)^kb(z)$, $k\\ge1$, and let $\\varrho$ be the joint spectral radius of the sections $(B_e)_{ij}=b_{e+pj-i}$, $e=0,\\dots,p-1$. If $\\varrho<p^{k-1}$, the exponent is at least "
                                        "$k-1-\\log_p\\varrho$. It is equal to it if the integer shifts of the basic limit function are stable and $k$ is the greatest possible order.")}));
  }
  if (theorems.contains(Theorem::n1)) {
    blocks.push_back(theorem("N1", " [@Warren1995], [@DaubechiesGuskovSweldens1999], [@KarciauskasPeters2013]",
                             {paragraph("Let (a) the scheme for equal intervals be $C^m$; (b) $L(\\gamma)v_k=2^{-k}v_k$ for $k=0,\\dots,m$ and all $\\gamma>0$, where $v_k$ are the $k$-th powers of the knots; "
                                        "(c) every other eigenvalue of $L(\\gamma)$, counted with multiplicity, be less than $2^{-m}$ in modulus; (d) no coefficient of the rule have a "
                                        "pole for positive ratios. Then the scheme is $C^m$ for every knot sequence.")}));
    blocks.push_back(paragraph(
        "Condition (c) is proved for the factors $f$ of the characteristic polynomial on boxes that cover $\\gamma\\in(0,1]$ and the region. With $r(z)=f(2^{-m}z)=\\sum_s r_sz^s$ of "
        "degree $d$ the tests are: *Rouch\u00e9*, $\\sum_{s<d}|r_s|<r_d$ for all Bernstein coefficients; *boundary*, $r(1)$, $(-1)^dr(-1)$ and $\\prod_{i<j}(1-z_iz_j)$ over the roots "
        "$z_i$ stay positive, so that no root leaves the disc from a point where all are inside; *circle*, $|r(\\mathrm{e}^{\\mathrm{i}t})|^2>0$ for all $t$; *sign separation*, sign changes "
        "along curves isolate the real roots and bound the others."));
  }
  if (theorems.contains(Theorem::n3)) {
    blocks.push_back(theorem("N3", "",
                             {paragraph("If for one $\\gamma>0$ the matrix $L(\\gamma)$ has, besides one simple eigenvalue $2^{-k}$ for each $k=0,\\dots,m$, an eigenvalue of modulus at least $2^{-m}$, or an eigenvalue $2^{-k}$, $k\\le m$, to which the $k$-th powers of the knots are no eigenvector, then the scheme "
                                        "is not $C^m$: its limit on the eigenvector's data contradicts a Taylor polynomial up to $o(t^m)$.")}));
  }
  if (theorems.contains(Theorem::s1)) {
    blocks.push_back(theorem("S1", " [@DynLevin1995]",
                             {paragraph("Let the masks $a^{(k)}$ of a nonstationary scheme have bounded supports and, for some $j\\le m$, the factor $\\sigma^j$; let $a$ be a mask with the same factor whose scheme is $C^m$ by "
                                        "Theorem U1, $c^{(k)}=p^ja^{(k)}/\\sigma^j$ and $c=p^ja/\\sigma^j$. If $\\sum_kp^{(m-j)k}\\lVert S_{c^{(k)}}-S_c\\rVert_\\infty<\\infty$, then the nonstationary scheme is $C^m$.")}));
  }
  if (theorems.contains(Theorem::s2)) {
    blocks.push_back(theorem("S2", " [@DynLevin1995]",
                             {paragraph("Let $\\tau=a'(1)/p$ for the limit mask, $s=\\tau/(p-1)$. A step with mask $a$ and edges of angle $\\theta h$ maps samples of $y^j\\mathrm{e}^{\\mathrm{i}n\\theta y}$ at $(l+s)ph$ to "
                                        "samples at $(i+s)h$ exactly if in every residue class of $i$ the moments $\\sum_{k\\equiv i}a_k(\\tau-k)^r\\mathrm{e}^{\\mathrm{i}n\\theta h(\\tau-k)}$, $r=0,\\dots,j$, are $1,0,\\dots,0$; it maps them into the "
                                        "space of $y^r\\mathrm{e}^{\\mathrm{i}n\\theta y}$, $r\\le j$, if the moments do not depend on the class.")}));
  }
  if (theorems.contains(Theorem::e1) || theorems.contains(Theorem::e2)) {
    blocks.push_back(paragraph("Around an extraordinary vertex or face of valence $n$ a surface scheme has a subdivision matrix $M$ on finitely many rings, which rotations split into Fourier blocks $j=0,\\dots,n-1$. It satisfies the "
                               "*spectral condition* if $1$ is a simple eigenvalue, of block $0$; the blocks $1$ and $n-1$ have the same simple real eigenvalue $\\lambda\\in(0,1)$; and all other eigenvalues are less than $\\lambda$ in modulus."));
    blocks.push_back(theorem("E1", " [@Reif1995], [@PetersReif2008]",
                             {paragraph("Let the curve scheme be $C^1$ by Theorem U1, the rules have weights of sum $1$ and the symmetry of the $n$-gon, the rings determine the limit and no control point of theirs but the vertex be without influence on it, and let there be a radius $\\varrho$ such that, counted with multiplicity, block $0$ has the "
                                        "eigenvalue $1$ and no other of modulus at least $\\varrho$, blocks $1$ and $n-1$ have one each, positive and less than $1$, and no other block has one. Then the spectral condition holds. If the matrices $M_k$ of the steps depend on "
                                        "$k$, it is that of their limit $M$, with $\\sum_k2^k\\lVert M_k-M\\rVert<\\infty$.")}));
  }
  if (theorems.contains(Theorem::e2)) {
    blocks.push_back(theorem("E2", " [@Reif1995], [@PetersReif2008]",
                             {paragraph("Let the rules be the same at every step and the hypotheses of Theorem E1 hold, and let $\\Phi$, the limit of the eigenvector of block $1$, have a positive Jacobian and satisfy $\\mathrm{Re}(\\mathrm{e}^{-\\mathrm{i}\\pi/n}\\Phi)>0$ in the first sector, on a closed "
                                        "annulus of regular pieces whose images under the powers of $\\lambda$ fill the plane. Then this characteristic map is a homeomorphism, and for all control points outside of a proper algebraic subset the limit surface is $C^1$ at the "
                                        "extraordinary point.")}));
  }
  if (theorems.contains(Theorem::p0)) {
    blocks.push_back(theorem("P0", "", {paragraph("Let the even or the odd coefficients of a binary mask not sum to $1$. Then $0$ is the only continuous limit. If moreover a product of the sections $(A_e)_{ij}=a_{e+2j-i}$ of the mask has "
                                                  "a real eigenvalue of at least $1$, the scheme is not $C^0$.")}));
  }
  if (theorems.contains(Theorem::p1) || theorems.contains(Theorem::p2)) {
    blocks.push_back(theorem("P1", "", {paragraph("Let $K$ be the cone over a box $0<l\\le z\\le u$ and $L\\ge1$ such that $K$ contains the vector of ones, every product of at most $L$ sections of the mask maps $K\\setminus0$ to positive vectors and every "
                                                  "product of $L$ of them into the interior of $K$, and for every such product any two rows of the matrices that map the points of windows have, by bounds over $K$, "
                                                  "a positive sum of entrywise minima. Then the projective scheme, which refines weights and weighted points and divides, converges.")}));
  }
  if (theorems.contains(Theorem::p2)) {
    blocks.push_back(theorem("P2", "", {paragraph("Let in addition $A_Wv_1=\\lambda_1v_1$ and $A_Wv_2=\\lambda_2v_2$ for a word $W$ of $k$ letters, with $v_1$ in the interior of $K$ and real $\\lambda_2$, $2^{-k}\\lambda_1<|\\lambda_2|<\\lambda_1$, and let the "
                                                  "limit of the points $A_Uv_2/A_Uv_1$ with weights $A_Uv_1$ not vanish for a word $U$ whose length is a multiple of $L$. Then the projective scheme is not $C^1$.")}));
  }
  return blocks;
}

}  // namespace limes::report_impl
