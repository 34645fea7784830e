#!/usr/bin/env python3
"""Works out the expected tables NAME.csv beside this file, with 40 digits, from closed forms of position alone.

Velocities and accelerations are numerical derivatives of those in 40 digits; nothing here knows of equivalent
links. Needs mpmath. `make_tables.py --check` compares with what is there and writes nothing."""
import pathlib
import sys

from mpmath import acos, asin, atan, atan2, cos, diff, hypot, mp, mpf, nstr, pi, sin, sqrt, tan

mp.dps = 40
DEG = pi / 180
HERE = pathlib.Path(__file__).parent
tables = {}


def near(angle, guess):
    """The angle at a whole number of turns that is nearest to the guess [rad]."""
    return angle + 2 * pi * mp.nint((guess - angle) / (2 * pi))


def derivatives(f, x, rate, acceleration=0):
    """f and its first two derivatives in time, where dx/dt and d²x/dt² are given."""
    first = diff(f, x)
    return f(x), first * rate, diff(f, x, 2) * rate**2 + first * acceleration


def table(name, head, rows):
    text = head + "\n" + "\n".join(",".join(nstr(mpf(v), 20, min_fixed=-30, max_fixed=30) for v in row) for row in rows) + "\n"
    tables[name] = text


def rocker(ground, crank, coupler, rocker_length, side, u):
    """Angles of coupler and rocker of a four-bar: the triangle of the two over the diagonal."""
    ax, ay = crank * cos(u), crank * sin(u)
    dx, dy = ground - ax, -ay
    d = hypot(dx, dy)
    t3 = atan2(dy, dx) + side * acos((coupler**2 + d**2 - rocker_length**2) / (2 * coupler * d))
    bx, by = ax + coupler * cos(t3), ay + coupler * sin(t3)
    return t3, atan2(by, bx - ground)


def follow(f, xs, start):
    """f at all xs, taken on continuously from `start`, in steps of at most a degree; as a function near each x."""
    out, x, last = [], xs[0], start
    for target in xs:
        n = int(abs(target - x) / DEG) + 1
        for i in range(1, n + 1):
            last = near(f(x + (target - x) * i / n), last)
        x = target
        out.append((target, lambda y, at=last: near(f(y), at)))
    return out


def four_bars():
    # Rows 0, π/2, π, 3π/2 of the table in rad; σ = +1 there is the coupler to the right of the diagonal.
    for name, side in (("four_bar_plus", -1), ("four_bar_minus", 1)):
        us = [k * pi / 2 for k in range(4)]
        starts = [t for t in rocker(1, 2, mpf("3.5"), 4, side, mpf(0))]
        columns = [follow(lambda u, i=i: rocker(1, 2, mpf("3.5"), 4, side, u)[i], us, starts[i]) for i in (0, 1)]
        rows = []
        for k, u in enumerate(us):
            t3 = derivatives(columns[0][k][1], u, 10, -7)
            t4 = derivatives(columns[1][k][1], u, 10, -7)
            rows.append([mpf(float(u)), *t3, *t4])
        table(name, "driver[rad],coupler.angle[rad],coupler.omega[rad/s],coupler.alpha[rad/s^2],"
              "rocker.angle[rad],rocker.omega[rad/s],rocker.alpha[rad/s^2]", rows)


def slider_crank():
    # Slide along 20°, its line 0.75 to the left of the crank's pivot; crank 2, coupler 5.
    across = lambda u: asin((mpf("0.75") - 2 * sin(u - 20 * DEG)) / 5)
    along = lambda u: 2 * cos(u - 20 * DEG) + 5 * cos(across(u))
    rows = []
    for deg in range(7, 360, 60):
        u = deg * DEG
        rows.append([deg, *derivatives(along, u, 3, -2), *[v / DEG for v in derivatives(lambda x: across(x) + 20 * DEG, u, 3, -2)]])
    table("slider_crank", "driver[deg],slide.position[m],slide.velocity[m/s],slide.acceleration[m/s^2],"
          "coupler.angle[deg],coupler.omega[deg/s],coupler.alpha[deg/s^2]", rows)


def circle_meeting(p, r, q, s, side):
    """The point at distance r from p and s from q, left of p -> q for side = 1."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    d = hypot(dx, dy)
    a = atan2(dy, dx) + side * acos((r**2 + d**2 - s**2) / (2 * r * d))
    return p[0] + r * cos(a), p[1] + r * sin(a)


def watt(u):
    e, f = (mpf(95), mpf(0)), (mpf(280), mpf(0))
    b = (40 * cos(u), 40 * sin(u))
    c = circle_meeting(b, 100, e, 95, 1)
    ce = atan2(e[1] - c[1], e[0] - c[0])
    ecf = acos(mpf(65**2) / (2 * 65 * 95))  # CE = EH = 95, CH = 65: angle ECH
    h = (c[0] + 65 * cos(ce + ecf), c[1] + 65 * sin(ce + ecf))
    d = circle_meeting(h, 120, f, 145, 1)
    return [atan2(c[1] - b[1], c[0] - b[0]), ce, atan2(h[1] - d[1], h[0] - d[0]), atan2(f[1] - d[1], f[0] - d[0])]


def watt_six_bar():
    degs = list(range(135, 496, 45))
    us = [d * DEG for d in degs]
    columns = [follow(lambda u, i=i: watt(u)[i], us, watt(us[0])[i]) for i in range(4)]
    rows = [[degs[k]] + [v / DEG for c in columns for v in derivatives(c[k][1], us[k], 1)] for k in range(len(us))]
    table("watt_six_bar", "driver[deg]," + ",".join(
        f"{b}.angle[deg],{b}.omega[deg/s],{b}.alpha[deg/s^2]" for b in ("link3", "link4", "link5", "link6")), rows)


def six_bar_with_slider():
    # Origin at the crank's pivot, second pivot (21, 0) cm; crank 15, links 18 and 20, E 7.5 from B along link 4, rod 25.
    def chain(t):
        u = 45 * DEG - 8 * t - mpf(5) / 2 * t * t
        a = (15 * cos(u), 15 * sin(u))
        b = circle_meeting(a, 18, (mpf(21), mpf(0)), 20, 1)
        t4 = atan2(-b[1], 21 - b[0])
        e = (b[0] + mpf("7.5") * cos(t4), b[1] + mpf("7.5") * sin(t4))
        t5 = asin((24 - e[1]) / 25)
        return atan2(b[1] - a[1], b[0] - a[0]), t4, t5, e[0] + 25 * cos(t5)
    t = mpf(1) / 2
    row = [t]
    for i in range(4):
        row += derivatives(lambda x: chain(x)[i], t, 1)[1:]
    table("six_bar_with_slider", "time[s],link3.omega[rad/s],link3.alpha[rad/s^2],link4.omega[rad/s],link4.alpha[rad/s^2],"
          "rod.omega[rad/s],rod.alpha[rad/s^2],slide.velocity[cm/s],slide.acceleration[cm/s^2]",
          [[0] + [x for i in range(4) for x in derivatives(lambda y: chain(y)[i], mpf(0), 1)[1:]], row])


def eccentric_discs():
    angle = lambda u: rocker(80, 10, 35, 60, 1, u)[1] - pi
    rows = []
    for deg in range(0, 361, 30):
        u = deg * DEG
        f = lambda x: near(angle(x), -35 * DEG)
        rows.append([deg, *[v / DEG for v in derivatives(f, u, 60 * DEG)]])
    table("eccentric_discs", "driver[deg],arm.position[deg],arm.velocity[deg/s],arm.acceleration[deg/s^2]", rows)


def ellipse_flat():
    # Support function of the ellipse, semi-axes 30 and 20 turned by 15°, centre (8, 3), in the direction 90° - u.
    lift = lambda u: (8 * sin(u) + 3 * cos(u)
                      + sqrt((30 * cos(pi / 2 - u - 15 * DEG))**2 + (20 * sin(pi / 2 - u - 15 * DEG))**2))
    rows = [[deg, *derivatives(lift, deg * DEG, 2 * pi, 5)] for deg in range(0, 361, 30)]
    table("ellipse_flat_face", "driver[deg],slide.position[mm],slide.velocity[mm/s],slide.acceleration[mm/s^2]", rows)


def rolling_ellipses():
    # e = 0.6: (1 + e)/(1 - e) = 4; r1 = 32/(1 - 0.6 cos u), ratio -r1/(100 - r1).
    angle = lambda u: -2 * atan(4 * tan(u / 2))
    rows = []
    for deg in (20, 50, 80, 110, 140, 170):
        u = deg * DEG
        r1 = 32 / (1 - mpf(6) / 10 * cos(u))
        value = derivatives(angle, u, 2)
        assert abs(value[1] + 2 * r1 / (100 - r1)) < mpf(10)**-25
        rows.append([deg, *[v / DEG for v in value], 0])
    table("rolling_ellipses", "driver[deg],follower_pivot.position[deg],follower_pivot.velocity[deg/s],"
          "follower_pivot.acceleration[deg/s^2],roll.sliding[mm/s]", rows)


def geneva():
    # Four slots: centre distance 80, crank 80/√2 as a double; the wheel's slot lies along the line to the pin.
    r = mpf(float(80 / sqrt(2)))
    angle = lambda u: -atan2(r * sin(u), 80 - r * cos(u))
    rows = [[deg, *[v / DEG for v in derivatives(angle, deg * DEG, 1)]] for deg in range(-45, 46, 15)]
    table("geneva_wheel", "driver[deg],wheel_pivot.position[deg],wheel_pivot.velocity[deg/s],wheel_pivot.acceleration[deg/s^2]", rows)


def pin_in_slot():
    # Pivots 30 apart, pin at 50: the lever turns fully (quick return).
    us = [k * 30 * DEG for k in range(13)]
    lever = follow(lambda u: atan2(50 * sin(u), 50 * cos(u) + 30), us, mpf(0))
    rows = []
    for k, u in enumerate(us):
        rows.append([30 * k, *[v / DEG for v in derivatives(lever[k][1], u, 2, 1)],
                     *derivatives(lambda x: sqrt(mpf(50)**2 + 30**2 + 2 * 50 * 30 * cos(x)), u, 2, 1)])
    table("pin_in_slot", "driver[deg],lever_pivot.position[deg],lever_pivot.velocity[deg/s],lever_pivot.acceleration[deg/s^2],"
          "pin.position[mm],pin.velocity[mm/s],pin.acceleration[mm/s^2]", rows)


for make in (four_bars, slider_crank, watt_six_bar, six_bar_with_slider, eccentric_discs, ellipse_flat, rolling_ellipses,
             geneva, pin_in_slot):
    make()
check = sys.argv[1:] == ["--check"]
for name, text in tables.items():
    path = HERE / (name + ".csv")
    if check and path.read_text() != text:
        sys.exit(f"{path}: differs")
    if not check:
        path.write_text(text)
