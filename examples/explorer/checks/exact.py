"""Compares roots of the bridge with those of its closed form, in 40 digits: python3 exact.py ROOTS"""

import json
import sys
from math import pi

from mpmath import mp, mpc, mpf, sin, sinh, sqrt

mp.dps = 40
M, PACE = mpf(1500), mpf(730)
EI = M * PACE**2


def determinant(values, damped):
    """(1 + Y/F D) sin βl with the deflection Y of a pinned beam under a force F where the damper of stiffness D hangs."""
    damping, stiffness, mass, place, span, ratio = values
    # as the sliders' numbers become those of the model, rounded to doubles: roots are held closer than rounding moves them
    stiffness, place, ratio = mpf(stiffness * 1e3), place * 0.01, ratio * 0.01
    air = mpf(2.0 * ratio * float(M) * float(PACE) * (pi / span) * (pi / span)) if damped else 0
    damping = mpf(damping) if damped else 0
    a, b = mpf(place * span), mpf((1.0 - place) * span)
    l = a + b

    def value(s):
        beta = sqrt(sqrt(-(M * s * s + air * s) / EI))
        above = sin(beta * a) * sin(beta * b) - sinh(beta * a) * sinh(beta * b) * sin(beta * l) / sinh(beta * l)
        link, inertia = stiffness + damping * s, mpf(mass) * s * s
        return sin(beta * l) + above / (2 * EI * beta**3) * link * inertia / (link + inertia)

    return value


def nearest_root(value, start):
    """The root that the secant method reaches."""
    before, root = start * (1 + mpf("1e-6")), start
    values = [value(before), value(root)]
    for _ in range(10):
        if values[0] == values[1]:
            break
        before, root = root, root - values[1] * (root - before) / (values[1] - values[0])
        values = [values[1], value(root)]
    return root


def main(file):
    worst, count, outside = 0, 0, 0
    for case in json.load(open(file)):
        for root in case["eigenvalues"]:
            found = mpc(root["re"], root["im"])
            exact = nearest_root(determinant(case["values"], True), found)
            worst, count = max(worst, abs(exact - found) / abs(exact)), count + 1
            outside += abs(exact - found) > root["error"]
        for root in case["frequencies"]:
            exact = nearest_root(determinant(case["values"], False), mpc(0, root["omega"])).imag
            worst, count = max(worst, abs(exact - root["omega"]) / exact), count + 1
            outside += not root["lower"] <= exact <= root["upper"]
    print(f"bridge: {count} roots differ from those of the closed form by {mp.nstr(worst, 2)} at most; {outside} outside of disc or interval")
    if count == 0 or outside or not worst < 1e-14:
        sys.exit("the bridge is not exact")


main(sys.argv[1])
