"""Prints the first ten frequencies of the portal in hertz, twenty digits of forty: exact stiffnesses of clamped members, counted by signs.

`pip install mpmath`, then `python3 exact.py`.
"""

from mpmath import cos, cosh, floor, matrix, mp, mpf, pi, sin, sinh, sqrt

mp.dps = 40
AXIAL, BENDING, MASS = mpf("1.26e9"), mpf("5.25e6"), mpf("47.1")
HEIGHT, SPAN = mpf(4), mpf(6)


def rod(omega, length):
    """The stiffnesses of a rod that is held at both ends, and how many frequencies it has there."""
    wave = omega * sqrt(MASS / AXIAL)
    return AXIAL * wave * cos(wave * length) / sin(wave * length), -AXIAL * wave / sin(wave * length), int(floor(wave * length / pi))


def beam(omega, length):
    """The stiffnesses of a clamped beam: at the end [QY, QΘ, MΘ], between the ends [QY, QΘ, MΘ]; and its count."""
    wave = sqrt(omega) * (MASS / BENDING) ** mpf("0.25")
    z = wave * length
    s, c, big_s, big_c = sin(z), cos(z), sinh(z), cosh(z)
    d = 1 - c * big_c
    here = [wave**3 * (c * big_s + s * big_c), wave**2 * s * big_s, wave * (s * big_c - c * big_s)]
    there = [-(wave**3) * (s + big_s), wave**2 * (big_c - c), wave * (big_s - s)]
    whole = int(floor(z / pi))
    count = whole - (1 - (-1) ** whole * (1 if d > 0 else -1)) // 2
    return [BENDING * value / d for value in here], [BENDING * value / d for value in there], count


def negative(stiffness):
    """The number of negative eigenvalues, by pivots."""
    size, k, count = stiffness.rows, stiffness.copy(), 0
    for i in range(size):
        count += k[i, i] < 0
        for j in range(i + 1, size):
            for m in range(i + 1, size):
                k[j, m] -= k[j, i] * k[i, m] / k[i, i]
    return int(count)


def below(omega):
    """How many frequencies lie below: corners with x, y and the rotation, first the left one, then the right one."""
    (axial, axial_far, in_rod), (bend, bend_far, in_beam) = rod(omega, SPAN), beam(omega, SPAN)
    (column, _, in_column), (sway, _, in_sway) = rod(omega, HEIGHT), beam(omega, HEIGHT)
    k = matrix(6, 6)
    for corner, side in ((0, 1), (3, -1)):
        k[corner, corner] = sway[0] + axial
        k[corner + 1, corner + 1] = column + bend[0]
        k[corner + 2, corner + 2] = sway[2] + bend[2]
        # a column turns where its head moves along x, the girder where its end moves along y
        k[corner, corner + 2] = k[corner + 2, corner] = sway[1]
        k[corner + 1, corner + 2] = k[corner + 2, corner + 1] = side * bend[1]
    for i, j, value in ((0, 3, axial_far), (1, 4, bend_far[0]), (1, 5, bend_far[1]), (2, 4, -bend_far[1]), (2, 5, bend_far[2])):
        k[i, j] = k[j, i] = value
    return in_rod + in_beam + 2 * (in_column + in_sway) + negative(k)


def root(number):
    low, high = mpf(1), mpf(4000)
    while high - low > mpf("1e-25") * high:
        middle = (low + high) / 2
        low, high = (low, middle) if below(middle) >= number else (middle, high)
    return (low + high) / 2


for number in range(1, 11):
    print(mp.nstr(root(number) / (2 * pi), 20))
