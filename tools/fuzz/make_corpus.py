#!/usr/bin/env python3
"""Writes the hand-made inputs of the fuzz targets."""
import math
import pathlib
import struct

corpus = pathlib.Path(__file__).parent / "corpus"
(corpus / "conic").mkdir(parents=True, exist_ok=True)
(corpus / "profile").mkdir(parents=True, exist_ok=True)

conics = {
    "circle": ([1, 1, 0, -4, 6, -3], 0, 0),
    "ellipse": ([7, 13, -6, 10, -20, -3600], 0, 0),
    "parabola": ([1, 0, 0, 0, -4, 0], 0, 1),
    "hyperbola": ([1, -2, 0.5, 3, 0, -7], 5, 0),
    "hyperbola_centre": ([1, -1, 0, 0, 0, -1], 0, 0),
    "nearly_parabola": ([1, 1e-15, 0, 0, -4, 0], 0, 1),
    "crossing_lines": ([1, -1, 0, 0, 0, 0], 1, 0),
    "double_line": ([1, 1, 2, 0, 0, 0], 1, 0),
    "imaginary": ([1, 1, 0, 0, 0, 1], 0, 0),
    "single_point": ([1, 1, 0, -2, 0, 1], 0, 0),
    "no_quadratic_part": ([0, 0, 0, 1, 1, 1], 0, 0),
    "zero": ([0] * 6, 0, 0),
    "nan": ([math.nan, 1, 0, 0, 0, -1], 0, 0),
    "infinite": ([1, math.inf, 0, 0, 0, -1], 0, 0),
    "huge": ([1e300, 1e300, 0, 1e300, 0, -1e300], 0, 0),
    "tiny": ([1e-300, 1e-300, 0, 0, 0, -1e-300], 0, 0),
    "subnormal": ([5e-324, 5e-324, 0, 0, 0, -5e-324], 0, 0),
    "far_away": ([1, 1, 0, -2e150, 0, 1e300], 0, 0),
    "stretched": ([1e-12, 1e12, 0, 0, 0, -1], 0, 0),
}
for name, (coefficients, x, y) in conics.items():
    for side in (0, 1):
        data = struct.pack("<8d", *coefficients, x, y) + bytes([side])
        (corpus / "conic" / f"{name}_{side}").write_bytes(data)

deep = "[" * 2000 + "]" * 2000
profiles = {
    "empty": b"",
    "byte_order_mark": b"\xef\xbb\xbfformat = 1\r\n",
    "no_utf8": b"title = \"\xff\xfe\"\n",
    "nul": b"title = \"a\0b\"\n",
    "newer": b"format = 2\n",
    "wrong_types": b"gravity = \"down\"\nbodies = 3\njoints = []\ndriver = [1]\n",
    "unknown_unit": b"[units]\nlength = \"furlong\"\n",
    "quantities": b"gravity = [\"1e400 m/s^2\", \"9.81 m/s^\"]\n[bodies.a]\nmass = \"1 kg m\"\n",
    "ground_moves": b"[bodies.ground]\npose = { x = 1 }\nmass = 1\n",
    "itself": b"[bodies.a]\npoints.P = [0, 0]\n[joints.j]\ntype = \"revolute\"\nbetween = [\"a.P\", \"a.P\"]\n"
              b"[driver]\njoint = \"j\"\n",
    "no_numbers": b"[bodies.a]\npoints.P = [nan, inf]\ncurves.c = { type = \"circle\", center = [0], radius = -0.0 }\n",
    "huge_samples": b"[bodies.a]\npoints.P = [0, 0]\n[bodies.ground]\npoints.P = [0, 0]\n[joints.j]\ntype = \"revolute\"\n"
                    b"between = [\"ground.P\", \"a.P\"]\n[driver]\njoint = \"j\"\nsamples = 9223372036854775807\nend = 1e308\n",
    "deep": ("x = " + deep + "\n").encode(),
    "unfinished": b"[bodies.ground\npoints.O = [0, ",
}
for name, data in profiles.items():
    (corpus / "profile" / f"{name}.toml").write_bytes(data)
