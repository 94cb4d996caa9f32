#!/usr/bin/python3
"""Makes heavy_cantilever.csv: an inextensible elastica, clamped level, bent by its own weight.

With the distance u from the free end over the length, the angle of drop th and lambda = w L^3/(E I):
th'' = -lambda u cos th, th'(0) = 0, th(1) = 0; found by bisection of th(0), integrated by Runge and Kutta's method of
fourth order.
"""

import os

import numpy as np


def integrate(weight, tip_angle, steps):
    """th, its derivative, and how far the clamp lies behind and above the tip, over the length."""
    def rate(u, y):
        return np.array([y[1], -weight * u * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])])
    y, h = np.array([tip_angle, 0.0, 0.0, 0.0]), 1.0 / steps
    for k in range(steps):
        a = rate(k * h, y)
        b = rate((k + 0.5) * h, y + 0.5 * h * a)
        c = rate((k + 0.5) * h, y + 0.5 * h * b)
        d = rate((k + 1.0) * h, y + h * c)
        y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d)
    return y


def tip_angle(weight):
    """Of the branch that hangs without a turn: below a right angle."""
    low, high = 0.0, 0.5 * np.pi
    while high - low > 1e-13:
        middle = 0.5 * (low + high)
        if integrate(weight, middle, 2000)[0] < 0.0:
            low = middle
        else:
            high = middle
    return low


def main():
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "heavy_cantilever.csv"), "w") as file:
        file.write("# inextensible elastica under its own weight (heavy_cantilever.py): lambda = w L^3/(E I), chord_deg: "
                   "angle of the line from clamp to tip below the level, tip over the length\n")
        file.write("lambda,chord_deg,x_over_L,drop_over_L\n")
        for weight in (1.0, 8.0, 64.0):
            _, _, x, drop = integrate(weight, tip_angle(weight), 2000)
            file.write(f"{weight:g},{np.degrees(np.arctan2(drop, x)):.8f},{x:.10f},{drop:.10f}\n")


main()
