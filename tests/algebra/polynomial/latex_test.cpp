#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace limes {
namespace {

std::string latex(const std::string& text, const VariableNames& names) {
  return to_latex(read_rational_function(text, names), names);
}

TEST(Latex, Polynomials) {
  EXPECT_EQ(latex("w/2+1/16", {"w"}), "\\frac{w}{2}+\\frac{1}{16}");
  EXPECT_EQ(latex("1-w", {"w"}), "-w+1");
  EXPECT_EQ(latex("0", {"w"}), "0");
  EXPECT_EQ(latex("1", {}), "1");
  EXPECT_EQ(latex("-7/3", {}), "-\\frac{7}{3}");
  EXPECT_EQ(latex("-w^2", {"w"}), "-w^{2}");
  EXPECT_EQ(latex("-3*w^12*v/4", {"v", "w"}), "-\\frac{3 v w^{12}}{4}");
  EXPECT_EQ(latex("2*w*(w-5)", {"w"}), "2 w^{2}-10 w");
  EXPECT_EQ(latex("10000000000000000000000*w", {"w"}), "10000000000000000000000 w");
}

TEST(Latex, Fractions) {
  EXPECT_EQ(latex("1/w", {"w"}), "\\frac{1}{w}");
  EXPECT_EQ(latex("-1/w", {"w"}), "-\\frac{1}{w}");
  EXPECT_EQ(latex("(w/2)/(w-1/3)", {"w"}), "\\frac{3 w}{6 w-2}");
  EXPECT_EQ(latex("(1-w)/(1+w)", {"w"}), "-\\frac{w-1}{w+1}");
}

TEST(Latex, Names) {
  EXPECT_EQ(latex("x", {"x"}), "x");
  EXPECT_EQ(latex("beta", {"beta"}), "\\beta");
  EXPECT_EQ(latex("beta_1^2", {"beta_1"}), "\\beta_{1}^{2}");
  EXPECT_EQ(latex("w1", {"w1"}), "w_{1}");
  EXPECT_EQ(latex("w_left_2", {"w_left_2"}), "w_{\\mathrm{left},2}");
  EXPECT_EQ(latex("tension", {"tension"}), "\\mathrm{tension}");
  EXPECT_EQ(latex("x_mu", {"x_mu"}), "x_{\\mu}");
  EXPECT_EQ(latex("Gamma", {"Gamma"}), "\\Gamma");
}

TEST(Latex, WrongNumberOfNames) { EXPECT_THROW(to_latex(RationalFunction(2), {"w"}), DomainError); }

TEST(Latex, ThreadsPrintTheSame) {
  const VariableNames names = {"gamma_1", "w"};
  const RationalFunction f = read_rational_function("(gamma_1+w)^8/(gamma_1-w)", names);
  const std::string expected = to_latex(f, names);
  std::vector<int> equal(4, 0);
  std::vector<std::thread> threads;
  for (int& count : equal) {
    threads.emplace_back([&] {
      for (int i = 0; i < 100; ++i) count += to_latex(f, names) == expected ? 1 : 0;
    });
  }
  for (auto& thread : threads) thread.join();
  EXPECT_EQ(equal, std::vector<int>(4, 100));
}

}  // namespace
}  // namespace limes
