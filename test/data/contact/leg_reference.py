#!/usr/bin/python3
"""Contact pressure of the shipped pantyhose legs, computed without Toile.

    leg_reference.py [intervals along, terms across]    writes leg_rebar.csv and leg_itskov.csv here

A frictionless membrane on a body of revolution, in coordinates of the body: height z and angle theta of every point of
the pattern are series, even and odd, across the panel and cubic B-splines along it. The strain energy is minimised by
Newton's method with exact second derivatives; the fabric lies half its current thickness above the body. The pressure
is tension : curvature. Units: mm, N, MPa. Needs numpy. Default: 60 intervals, 3 terms; takes a minute.
"""
import numpy as np

# input/pantyhose-leg.xml
GIRTHS, HEIGHTS = np.array([205.0, 340.0, 310.0, 520.0]), np.array([114.0, 334.0, 423.0, 728.0])
LEVELS = np.array([0, 30, 75, 120, 160, 200, 240, 275, 330, 400, 455, 514.0])
WIDTHS = np.array([52, 53.4, 62.3, 77.5, 91.3, 98.4, 95.2, 91.1, 93.9, 112.1, 134.4, 162.3])
ENDS, H0 = (100.0, 740.0), 1.0
REPORTED = {"B": 114, "B1": 200, "C": 334, "D": 390, "F": 580, "G": 728}


class Jet:
    """Value, gradient and Hessian by several variables; arrays over points."""

    def __init__(self, v, g, h):
        self.v, self.g, self.h = v, g, h

    @staticmethod
    def variables(*values):
        n = len(values)
        out = []
        for i, v in enumerate(values):
            g = np.zeros(v.shape + (n,))
            g[..., i] = 1.0
            out.append(Jet(v, g, np.zeros(v.shape + (n, n))))
        return out

    def of(self, f, f1, f2):
        """f(self) by its value and first two derivatives."""
        gg = self.g[..., :, None] * self.g[..., None, :]
        return Jet(f, f1[..., None] * self.g, f1[..., None, None] * self.h + f2[..., None, None] * gg)

    def __add__(self, o):
        return Jet(self.v + o.v, self.g + o.g, self.h + o.h) if isinstance(o, Jet) else Jet(self.v + o, self.g, self.h)

    __radd__ = __add__

    def __sub__(self, o):
        return self + o * -1.0

    def __mul__(self, o):
        if not isinstance(o, Jet):
            return Jet(self.v * o, self.g * o, self.h * o)
        c = self.g[..., :, None] * o.g[..., None, :]
        return Jet(self.v * o.v, self.v[..., None] * o.g + o.v[..., None] * self.g,
                   self.v[..., None, None] * o.h + o.v[..., None, None] * self.h + c + np.swapaxes(c, -1, -2))

    __rmul__ = __mul__

    def power(self, a):
        return self.of(self.v**a, a * self.v ** (a - 1), a * (a - 1) * self.v ** (a - 2))


def rebar(c11, c22, c12):
    """The pantyhose set: neo-Hookean matrix, fibres along wale and course that carry tension only."""
    w = (c11 + c22 + (c11 * c22 - c12 * c12).power(-1.0) + (-3.0)) * 8.4667e-3
    wale, course = (0.0001, 0.1672, -2.225, 21.199, -62.05, 61.746), (0.0032, -0.075, 0.4653, -1.340, 1.9400, -0.986)
    for c, m in ((c11, wale), (c22, course)):
        e, i = 0.5 * np.log(c.v), np.arange(6)
        m = np.array(m)
        psi, stress, modulus = (np.polynomial.polynomial.polyval(e, q) * (e > 0)
                                for q in (np.r_[0, 0, m / ((i + 1) * (i + 2))], np.r_[0, m / (i + 1)], m))
        w = w + c.of(psi, 0.5 * stress / c.v, (0.25 * modulus - 0.5 * stress) / c.v**2)
    return w


def itskov(c11, c22, c12):
    """The pantyhose set; det C = 1."""
    det = c11 * c22 - c12 * c12
    c33 = det.power(-1.0)
    w = 0.0
    for mu, a, b, w1, w2 in ((1.2755e-2, 4.727, 1.003, 0.771, 0.229), (2.0569e-3, 1.475, 16.16, 0.585, 0.415),
                             (4.5867e-2, 1.736, 1.063, 0.652, 0.348)):
        w3 = 1 - w1 - w2
        j, k = c11 * w1 + c22 * w2 + c33 * w3, c22 * c33 * w1 + c11 * c33 * w2 + det * w3
        w = (j.power(a) + (-1.0)) * (0.25 * mu / a) + (k.power(b) + (-1.0)) * (0.25 * mu / b) + w
    return w


class Spline:
    """Natural cubic spline, continued by straight lines."""

    def __init__(self, x, y):
        n = len(x)
        a, r, h = np.zeros((n, n)), np.zeros(n), np.diff(x)
        a[0, 0] = a[-1, -1] = 1.0
        for i in range(1, n - 1):
            a[i, i - 1:i + 2] = h[i - 1] / 6, (h[i - 1] + h[i]) / 3, h[i] / 6
            r[i] = (y[i + 1] - y[i]) / h[i] - (y[i] - y[i - 1]) / h[i - 1]
        self.x, self.y, self.m = x, y, np.linalg.solve(a, r)

    def __call__(self, z):
        """Value and first three derivatives."""
        c = np.clip(z, self.x[0], self.x[-1])
        i = np.clip(np.searchsorted(self.x, c) - 1, 0, len(self.x) - 2)
        h, ma, mb = self.x[i + 1] - self.x[i], self.m[i], self.m[i + 1]
        s, t = (self.x[i + 1] - c) / h, (c - self.x[i]) / h
        v = s * self.y[i] + t * self.y[i + 1] + ((s**3 - s) * ma + (t**3 - t) * mb) * h * h / 6
        d = (self.y[i + 1] - self.y[i]) / h + ((1 - 3 * s * s) * ma + (3 * t * t - 1) * mb) * h / 6
        inside = c == z
        return v + d * (z - c), d, inside * (s * ma + t * mb), inside * (mb - ma) / h


BODY = Spline(np.r_[(2 * HEIGHTS[0] - HEIGHTS[1:])[::-1], HEIGHTS], np.r_[GIRTHS[:0:-1], GIRTHS] / (2 * np.pi))
WIDTH = Spline(LEVELS, WIDTHS)


def meridian(z, g):
    """Radius R and height Z of the surface at the distance g above the body, d(R, Z)/dz and d2/dz2; g varies slowly."""
    r, d, dd, ddd = BODY(z)
    q = np.sqrt(1 + d * d)
    n, m = np.array([1 / q, -d / q]), np.array([d / q, 1 / q])  # normal and tangent (R, Z): n' = -k m, m' = k n
    k = dd / q**2
    kk = ddd / q**2 - 2 * d * dd * dd / q**4
    p = np.array([r, z]) + g * n
    p1 = np.array([d, np.ones_like(z)]) + g * -k * m
    p2 = np.array([dd, np.zeros_like(z)]) + g * (-kk * m - k * k * n)
    return p, p1, p2


def b_splines(x, intervals, length):
    """Values and derivatives of the cubic B-splines on [0, length]: [x][intervals + 3]."""
    t = np.r_[[0.0] * 3, np.linspace(0, length, intervals + 1), [length] * 3]
    b = [((t[i] <= x) & (x < t[i + 1])) * 1.0 for i in range(len(t) - 1)]
    last = np.nonzero(np.diff(t))[0][-1]
    b[last] = np.where(x == length, 1.0, b[last])

    def over(u, v):
        return u / v if v > 0 else 0.0 * u

    for k in range(1, 4):
        lower = b
        b = [over(x - t[i], t[i + k] - t[i]) * lower[i] + over(t[i + k + 1] - x, t[i + k + 1] - t[i + 1]) * lower[i + 1]
             for i in range(len(t) - 1 - k)]
    d = [3 * (over(lower[i], t[i + 3] - t[i]) - over(lower[i + 1], t[i + 4] - t[i + 1])) for i in range(len(b))]
    return np.array(b).T, np.array(d).T


class Leg:
    """The state: z = sum_i c_i(Y) x^(2 i), theta = pi/2 (x + sum_j a_j(Y) (x - x^(2 j + 1))), x = 2 X / width in 0..1."""

    def __init__(self, law, intervals=60, terms=3):
        self.law, self.intervals, self.terms, self.length = law, intervals, terms, LEVELS[-1]
        gy, wy = np.polynomial.legendre.leggauss(4)
        gx, wx = np.polynomial.legendre.leggauss(6)
        h = self.length / intervals
        y = ((np.arange(intervals)[:, None] + 0.5 + 0.5 * gy) * h).ravel()
        y, x = (a.ravel() for a in np.meshgrid(y, 0.5 + 0.5 * gx, indexing="ij"))
        self.weight = np.outer(np.tile(0.5 * h * wy, intervals), 0.5 * wx).ravel() * 0.5 * WIDTH(y)[0]
        self.y, self.x = y, x
        self.basis = self.linear(y, x)
        n = intervals + 3
        greville = np.convolve(np.r_[[0.0] * 2, np.linspace(0, self.length, intervals + 1), [self.length] * 2],
                               np.ones(3) / 3, "valid")
        self.u = np.zeros(n * (2 * terms + 1))
        self.u[:n] = ENDS[0] + (ENDS[1] - ENDS[0]) * greville / self.length
        self.g = np.full(y.shape, 0.25)
        held = [k * n + e for k in range(terms + 1) for e in (0, n - 1)]
        self.free = np.setdiff1d(np.arange(len(self.u)), held)

    def linear(self, y, x):
        """(z, z_Y, z_X, theta, theta_Y, theta_X) = basis . u + constant."""
        b, d = b_splines(y, self.intervals, self.length)
        w, w1 = WIDTH(y)[:2]
        x_X, x_Y = 2 / w, -x * w1 / w
        zero, rows = np.zeros_like(b), [[] for _ in range(6)]
        for k in range(self.terms + 1):
            f, f1 = x ** (2 * k), 2 * k * x ** max(2 * k - 1, 0)
            parts = (f[:, None] * b, f[:, None] * d + (f1 * x_Y)[:, None] * b, (f1 * x_X)[:, None] * b, zero, zero, zero)
            [r.append(p) for r, p in zip(rows, parts)]
        for k in range(1, self.terms + 1):
            f, f1 = x - x ** (2 * k + 1), 1 - (2 * k + 1) * x ** (2 * k)
            parts = (zero, zero, zero, f[:, None] * b, f[:, None] * d + (f1 * x_Y)[:, None] * b, (f1 * x_X)[:, None] * b)
            [r.append(0.5 * np.pi * p) for r, p in zip(rows, parts)]
        constant = np.zeros((6,) + y.shape)
        constant[3:] = 0.5 * np.pi * np.array([x, x_Y, x_X])
        return np.array([np.hstack(r) for r in rows]), constant

    def strains(self, q, g):
        z, z_y, z_x, theta, t_y, t_x = Jet.variables(*q)
        p, p1, p2 = meridian(q[0], g)
        # squares of the metric by z, their second derivatives from central differences of the first
        radius2 = z.of(p[0] ** 2, 2 * p[0] * p1[0], 2 * (p1[0] ** 2 + p[0] * p2[0]))
        e = 1e-3
        plus, minus = meridian(q[0] + e, g), meridian(q[0] - e, g)
        slope = [2 * np.sum(m[1] * m[2], 0) for m in (plus, minus)]
        metric = z.of(np.sum(p1**2, 0), 2 * np.sum(p1 * p2, 0), (slope[0] - slope[1]) / (2 * e))
        return (metric * z_y * z_y + radius2 * t_y * t_y, metric * z_x * z_x + radius2 * t_x * t_x,
                metric * z_y * z_x + radius2 * t_y * t_x)

    def evaluate(self, u):
        q = self.basis[0] @ u + self.basis[1]
        with np.errstate(all="ignore"):
            w = self.law(*self.strains(q, self.g))
        return w, q

    def settle(self):
        for _ in range(6):  # of the offset
            for _ in range(200):
                w, _ = self.evaluate(self.u)
                b, free = self.basis[0][:, :, self.free], self.free
                energy = np.sum(self.weight * w.v)
                f = np.einsum("p,pi,ipk->k", self.weight, w.g, b, optimize=True)
                h = w.h
                if np.linalg.norm(f) > 1e-4:  # far from the end: made positive
                    eigen, vector = np.linalg.eigh(h)
                    h = np.einsum("pik,pk,pjk->pij", vector, np.maximum(eigen, 1e-9), vector)
                k = sum(b[i].T @ ((self.weight * h[:, i, j])[:, None] * b[j]) for i in range(6) for j in range(6))
                step = -np.linalg.solve(k, f)
                s = 1.0
                while s > 1e-8:
                    trial = self.u.copy()
                    trial[free] += s * step
                    e = np.sum(self.weight * self.evaluate(trial)[0].v)
                    if e <= energy + 1e-4 * s * (f @ step) + 1e-13 * abs(energy):
                        break
                    s *= 0.5
                self.u = trial
                if np.linalg.norm(step) < 1e-9 * np.linalg.norm(self.u):
                    break
            else:
                raise RuntimeError("not converged")
            before = self.g
            self.g = 0.5 * H0 / np.sqrt(self.area_stretch_squared(self.basis))
            self.hold_ends()
            if np.max(abs(self.g - before)) < 1e-6:
                return self
        raise RuntimeError("the offset did not converge")

    def area_stretch_squared(self, basis):
        c = [s.v for s in self.strains(basis[0] @ self.u + basis[1], self.g)]
        return c[0] * c[1] - c[2] ** 2

    def hold_ends(self):
        """The held height is that of the fabric, g above the body."""
        n = self.intervals + 3
        for end, at in ((0, 0.0), (n - 1, self.length)):
            g, z = np.interp(at, self.y[::6], self.g[::6]), self.u[end]
            for _ in range(50):
                z -= float(meridian(np.array(z), g)[0][1]) - ENDS[0 if end == 0 else 1]
            self.u[end] = z

    def pressure(self, height):
        """Mean, smallest and largest pressure (MPa) round the section at a height of the fabric, and its girth (mm)."""
        x, w = np.polynomial.legendre.leggauss(24)
        x, w = 0.5 + 0.5 * x, 0.5 * w
        low, high = np.zeros_like(x), np.full_like(x, self.length)
        for _ in range(60):
            y = 0.5 * (low + high)
            q, g = self.at(y, x)
            above = meridian(q[0], g)[0][1] > height
            high, low = np.where(above, y, high), np.where(above, low, y)
        q, g = self.at(y, x)
        p, p1, p2 = meridian(q[0], g)
        rho = np.sqrt(np.sum(p1**2, 0))
        f = np.array([[rho * q[1], rho * q[2]], [p[0] * q[4], p[0] * q[5]]])
        c = np.einsum("iap,ibp->abp", f, f)
        law = self.law(*Jet.variables(c[0, 0], c[1, 1], c[0, 1]))
        s = np.array([[2 * law.g[:, 0], law.g[:, 2]], [law.g[:, 2], 2 * law.g[:, 1]]])
        t = H0 * np.einsum("iap,abp,jbp->ijp", f, s, f) / (f[0, 0] * f[1, 1] - f[0, 1] * f[1, 0])
        along = (p1[0] * p2[1] - p2[0] * p1[1]) / rho**3
        around = p1[1] / (p[0] * rho)
        value = t[0, 0] * along + t[1, 1] * around
        # weights of the section: d(theta) at a constant height
        slope = q[5] * 0.5 * WIDTH(y)[0] - q[4] * (q[2] * 0.5 * WIDTH(y)[0]) / q[1]
        share = w * slope / np.sum(w * slope)
        return np.sum(share * value), value.min(), value.max(), 2 * np.pi * np.sum(share * p[0])

    def at(self, y, x):
        basis = self.linear(y, x)
        q = basis[0] @ self.u + basis[1]
        g = np.full(y.shape, 0.25)
        for _ in range(4):
            c = [s.v for s in self.strains(q, g)]
            g = 0.5 * H0 / np.sqrt(c[0] * c[1] - c[2] ** 2)
        return q, g


if __name__ == "__main__":
    import sys
    for name, law in (("rebar", rebar), ("itskov", itskov)):
        leg = Leg(law, *(int(a) for a in sys.argv[1:])).settle()
        with open(f"leg_{name}.csv", "w") as out:
            out.write(f"# pantyhose leg, {name}: sections at the levels {', '.join(REPORTED)}; mm, MPa\n")
            out.write("# made by leg_reference.py\n")
            out.write("z,p_mean,p_min,p_max,girth\n")
            for height in REPORTED.values():
                out.write(f"{height}," + ",".join(f"{v:.8e}" for v in leg.pressure(height)) + "\n")
        print(name)
        print(open(f"leg_{name}.csv").read())
