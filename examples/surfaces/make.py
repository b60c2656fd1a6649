#!/usr/bin/python3
"""Writes the control nets of this folder: Examples 1 to 5 of Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021, with the corrections that
README.md explains. Every coordinate is the shortest decimal of its double."""
from math import cos, cosh, exp, pi, sin, sinh
from pathlib import Path

here = Path(__file__).parent


def write(name, comment, rows):
    lines = [f"# {comment}"]
    for row in rows:
        lines += [",".join(repr(x + 0.0) for x in point) for point in row]
    (here / f"{name}.csv").write_text("\n".join(lines) + "\n")


def sphere(scale):
    half = 7
    def point(m, n):
        u, v = pi * m / half, pi * n / half
        r = sin(u) if 0 < m < half else 0.0
        return (r * cos(v), scale * r * sin(v), cos(u))
    return [[point(m, n) for n in range(2 * half)] for m in range(half + 1)]


write("sphere", "8x14, poles, periodic columns; theta = pi/7", sphere(1))
write("ellipsoid", "8x14, poles, periodic columns; theta = pi/7", sphere(2))

turn = [2 * pi * m / 6 for m in range(6)]
write("cylinder", "5x6, periodic columns; linear along the rows, theta2 = pi/3",
      [[(cos(a), sin(a), n / 6) for a in turn] for n in range(5)])
write("cone", "7x6, periodic columns; linear along the rows, theta2 = pi/3",
      [[(n / 6 * cos(a), n / 6 * sin(a), n / 6) for a in turn] for n in range(7)])

eight = [2 * pi * n / 8 for n in range(8)]
write("torus", "8x8, periodic rows and columns; theta = pi/4",
      [[((3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)) for v in eight] for u in eight])

nine = [2 * pi * n / 9 for n in range(9)]
along = [2 * pi * m / 21 for m in range(-4, 5)]
write("hyperboloid", "9x9, periodic columns; hyperbolic along the rows with theta1 = 2*pi/21, theta2 = 2*pi/9: one sheet",
      [[(cosh(u) * cos(v), cosh(u) * sin(v), sinh(u)) for v in nine] for u in along])
half = [2 * pi * m / 21 for m in range(9)]
ten = [2 * pi * n / 10 for n in range(10)]
write("hyperboloid-cap", "9x10, first row a pole, periodic columns; hyperbolic with theta1 = 2*pi/21, theta2 = pi/5: the upper of two sheets",
      [[(sinh(u) * cos(v), sinh(u) * sin(v), cosh(u)) for v in ten] for u in half])

write("helicoid", "5x13; linear along the rows, theta2 = pi/6",
      [[((m - 2) / 2 * cos(pi * n / 6), (m - 2) / 2 * sin(pi * n / 6), n / 6) for n in range(13)] for m in range(5)])


def shell(m, n):
    u, v = 2 * pi * m / 12, 2 * pi * n / 12
    growth = exp(u / (6 * pi))
    return (2 * (1 - growth) * cos(u) * cos(v / 2) ** 2, 2 * (growth - 1) * sin(u) * cos(v / 2) ** 2,
            1 - exp(u / (3 * pi)) - sin(v) + growth * sin(v))


write("shell", "37x12, periodic columns; in none of the reproduced spaces; theta = pi/6",
      [[shell(m, n) for n in range(12)] for m in range(37)])
