// Rules of Karciauskas & Peters 2013 for the tests of this folder.
#pragma once

#include "schemes/nonuniform/insertion_rule.hpp"

namespace limes::test {

inline InsertionRule rule(const std::string& new_point, const VariableNames& parameters = {"w"}, int points = 0) {
  InsertionRuleText text;
  text.points = points;
  text.new_point = {new_point, 0};
  return {text, parameters};
}

inline InsertionRule cr1() { return rule("at(tension(16*w, hermite(1, f(2,0), f(2,1))), 1/2)"); }
inline InsertionRule a1_3_1() { return rule("16*w*at(f(3,0),1/2) + (1-16*w)*at(f(1,0),1/2)"); }
inline InsertionRule repeated_a1_3_1() { return rule("again(at(f(3,0),1/2))", {}); }
inline InsertionRule cr2() {
  const std::string cr = "join(2, degree(4, hermite(1, f(2,0), f(2,1))))";
  return rule("(576*w-2)*at(" + cr + ",1/2) + (3-576*w)*dot([1/12,1/6,1/2,1/6,1/12], " + cr + ")");
}
inline InsertionRule cu2_4() {
  const std::string cu = "join(2, degree(4, f(3,0)))";
  return rule("(576*w-2)*at(" + cu + ",1/2) + (3-576*w)*dot([1/12,1/6,1/2,1/6,1/12], " + cu + ")");
}
inline InsertionRule a2_5_3() { return rule("256/3*w*at(f(5,0),1/2) + (1-256/3*w)*at(f(3,0),1/2)"); }
inline InsertionRule a3_5_3_3() {
  return rule("(8/5-256/5*w)*at(f(5,0),1/2) + (256/5*w-3/5)*(at(f(3,-1),1/2) + at(f(3,1),1/2))/2");
}
inline InsertionRule a3_5() {
  return rule("(28-2304*w)*at(f(5,0),1/2) + (2304*w-27)*dot([1/12,0,5/12,5/12,0,1/12], f(5,0))");
}
inline InsertionRule ten_point() {
  return rule("(1-4096/5*w)*at(f(7,0),1/2) + 4096/5*w*(at(f(7,-1),1/2) + at(f(7,1),1/2))/2");
}
/// Not symmetric under reversal.
inline InsertionRule three_point() { return rule("16*w*at(f(2,0),1/2) + (1-16*w)*at(f(1,0),1/2)", {"w"}, 4); }

}  // namespace limes::test
