#!/usr/bin/python3
"""An independent recomputation of what the uniform provers rest on, by brute force in exact arithmetic.

For a few masks of the catalogue it prints one JSON object {"format": 1, "schemes": [...]}; each entry holds

  scheme, parameters   the catalogue name and the parameter values
  arity, first_index   p, and the index of mask[0]
  mask                 a, as rationals
  order                m
  sum_rules            the greatest k such that sigma^k divides a
  difference_mask      b of a = sigma^{m+1} p^{-m} b without leading or trailing zeros, or null if the factor is missing
  norms                ||S_b^l|| for l = 1, 2, ...
  words                [{word, characteristic_polynomial (lowest degree first), at_one = chi(1),
                       at_minus_one = (-1)^n chi(-1), radius_below_one}] for the products B_{e1} B_{e2} ... of the
                       finite sections

No polynomial product and no division by sigma is used: b comes from sigma = (1 - z^p)/(1 - z) as a power series, the
norms come from applying S_b to a unit impulse level by level, the characteristic polynomials from the traces of
Faddeev and LeVerrier.
Only the Python standard library is needed.
"""

import itertools
import json
import math
from fractions import Fraction as Q

def series_quotient(mask, arity, power):
    """The coefficients of a(z) (1-z)^power / (1-z^p)^power up to the end of a, and whether what follows vanishes."""
    series = mask + [Q(0)] * (arity * power + arity)
    for _ in range(power):
        series = [x - (series[i - 1] if i else 0) for i, x in enumerate(series)]
        for i in range(arity, len(series)):
            series[i] += series[i - arity]
    degree = len(mask) - 1 - power * (arity - 1)
    exact = degree >= 0 and not any(series[degree + 1:])
    return series[:max(degree, -1) + 1], exact

def difference_mask(mask, arity, order):
    series, exact = series_quotient(mask, arity, order + 1)
    if not exact:
        return None
    b = [x * arity**order for x in series]
    while b and b[-1] == 0:
        b.pop()
    while b and b[0] == 0:
        b.pop(0)
    return b

def sum_rules(mask, arity):
    count = 0
    while series_quotient(mask, arity, count + 1)[1]:
        count += 1
    return count

def over_one_denominator(b):
    denominator = math.lcm(*(x.denominator for x in b))
    return [int(x * denominator) for x in b], denominator

def norms(b, arity, levels):
    """||S_b^l||: the greatest sum of |response of S_b^l to a unit impulse| over one residue class modulo p^l."""
    b, denominator = over_one_denominator(b)
    response, result = {0: 1}, []
    for level in range(1, levels + 1):
        refined = {}
        for j, value in response.items():
            for k, coefficient in enumerate(b):
                refined[arity * j + k] = refined.get(arity * j + k, 0) + coefficient * value
        response = refined
        rows = {}
        for i, value in response.items():
            rows[i % arity**level] = rows.get(i % arity**level, 0) + abs(value)
        result.append(Q(max(rows.values()), denominator**level))
    return result

def section(b, arity, letter):
    size = max(1, -(-(len(b) - 1) // (arity - 1)))
    entry = lambda k: b[k] if 0 <= k < len(b) else 0
    return [[entry(letter + arity * j - i) for j in range(size)] for i in range(size)]

def product(left, right):
    return [[sum(x * y for x, y in zip(row, column)) for column in zip(*right)] for row in left]

def characteristic_polynomial(matrix):
    """det(lambda I - matrix) of an integer matrix, lowest degree first."""
    size = len(matrix)
    coefficients, power = [1], [[0] * size for _ in range(size)]
    for k in range(1, size + 1):
        for i in range(size):
            power[i][i] += coefficients[-1]
        power = product(matrix, power)
        coefficients.append(-sum(power[i][i] for i in range(size)) // k)
    return coefficients[::-1]

def radius_below_one(polynomial):
    """Schur's recursion: whether all roots lie inside the unit circle."""
    while len(polynomial) > 1:
        if abs(polynomial[0]) >= abs(polynomial[-1]):
            return False
        ratio = polynomial[0] / polynomial[-1]  # a monic recursion: the plain one doubles the digits in every step
        polynomial = [x - ratio * y for x, y in zip(polynomial, polynomial[::-1])][1:]
        polynomial = [x / polynomial[-1] for x in polynomial]
    return True

def word_facts(b, arity, word):
    b, denominator = over_one_denominator(b)
    matrix = section(b, arity, word[0])
    for letter in word[1:]:
        matrix = product(matrix, section(b, arity, letter))
    size, scale = len(matrix), denominator ** len(word)
    chi = [Q(x, scale ** (size - k)) for k, x in enumerate(characteristic_polynomial(matrix))]
    sign = (-1) ** size
    return {"word": list(word), "characteristic_polynomial": [str(x) for x in chi], "at_one": str(sum(chi)),
            "at_minus_one": str(sign * sum(x * (-1) ** i for i, x in enumerate(chi))),
            "radius_below_one": radius_below_one(chi)}

def interpolatory(half):
    """The binary mask whose new point has the weights half, mirrored."""
    mask = []
    for x in half + half[::-1]:
        mask += [x, Q(0)]
    mask.pop()
    mask[2 * len(half) - 1] = Q(1)
    return mask

def deslauriers_dubuc(points):
    knots, half = range(1 - points // 2, points // 2 + 1), []
    for i in knots:
        weight = Q(1)
        for j in knots:
            if j != i:
                weight *= (Q(1, 2) - j) / (i - j)
        half.append(weight)
    return interpolatory(half[:points // 2])

def b_spline(degree):
    mask = [Q(1)]
    for _ in range(degree + 1):
        mask = [x + y for x, y in zip([Q(0)] + mask, mask + [Q(0)])]
    return [x / 2**degree for x in mask]

def ternary(mu):
    a0, a1, a2, a3 = -Q(1, 18) - mu / 6, Q(13, 18) + mu / 2, Q(7, 18) - mu / 2, -Q(1, 18) + mu / 6
    return [a3, a0, Q(0), a2, a1, Q(1), a1, a2, Q(0), a0, a3]

def four(w):
    return interpolatory([-w, Q(1, 2) + w])

def six(w):
    return interpolatory([w, -3 * w - Q(1, 16), 2 * w + Q(9, 16)])

def eight(w):
    return interpolatory([-w, 5 * w + Q(3, 256), -9 * w - Q(25, 256), 5 * w + Q(75, 128)])

def twelve():
    narrow = [Q(0), Q(0)] + deslauriers_dubuc(10) + [Q(0), Q(0)]
    return [2 * x - y for x, y in zip(deslauriers_dubuc(12), narrow)]

# scheme, parameters, arity, mask, orders, levels, greatest length of words
CASES = [
    ("b-spline-3", {}, 2, b_spline(3), (2, 3), 3, 2),
    ("chaikin", {}, 2, b_spline(2), (1, 2), 3, 2),
    ("four-point", {"w": Q(1, 16)}, 2, four(Q(1, 16)), (1, 2), 6, 3),
    ("four-point", {"w": Q(1, 5)}, 2, four(Q(1, 5)), (0, 1, 2), 5, 3),
    ("six-point", {"w": Q(141, 10000)}, 2, six(Q(141, 10000)), (2, 3), 9, 3),
    ("six-point", {"w": Q(17, 1000)}, 2, six(Q(17, 1000)), (3,), 3, 2),
    ("eight-point", {"w": Q(1, 200)}, 2, eight(Q(1, 200)), (3, 4), 6, 3),
    ("deslauriers-dubuc-10", {}, 2, deslauriers_dubuc(10), (4, 5), 8, 2),
    ("twelve-point", {}, 2, twelve(), (5, 6), 7, 2),
    ("dual-four-point", {}, 2, [Q(x, 128) for x in (-5, -7, 35, 105, 105, 35, -7, -5)], (2, 3), 6, 2),
    ("ternary-four-point", {"mu": Q(1, 11)}, 3, ternary(Q(1, 11)), (1, 2, 3), 4, 2),
    ("ternary-four-point", {"mu": Q(1, 9)}, 3, ternary(Q(1, 9)), (2,), 4, 2),
    ("six-point-weissman-a", {}, 2, interpolatory([Q(1, 10), -Q(1, 4), Q(13, 20)]), (1, 2), 5, 2),
    ("six-point-weissman-b", {}, 2, interpolatory([Q(1, 20), -Q(17, 80), Q(53, 80)]), (1, 2), 5, 3),
]

def main():
    table = []
    for scheme, parameters, arity, mask, orders, levels, longest in CASES:
        assert sum(mask) == arity
        for order in orders:
            b = difference_mask(mask, arity, order)
            words = [w for n in range(1, longest + 1) for w in itertools.product(range(arity), repeat=n)]
            table.append({
                "scheme": scheme, "parameters": {k: str(v) for k, v in parameters.items()}, "arity": arity,
                "first_index": -(len(mask) // 2), "mask": [str(x) for x in mask], "order": order,
                "sum_rules": sum_rules(mask, arity),
                "difference_mask": None if b is None else [str(x) for x in b],
                "norms": [] if b is None else [str(x) for x in norms(b, arity, levels)],
                "words": [] if b is None else [word_facts(b, arity, w) for w in words]})
    print(json.dumps({"format": 1, "schemes": table}, indent=1))

if __name__ == "__main__":
    main()
