"""What a report page carries, for tests: unpacked as the browser does it."""

import base64
import gzip
import json
import re

import numpy


class Page:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.html = file.read()
        self.data = json.loads(self.unpack("data"))

    def unpack(self, name):
        match = re.search(f'<script type="text/plain" id="{name}">([A-Za-z0-9+/=]*)</script>', self.html)
        assert match, f"the page has no '{name}'"
        return gzip.decompress(base64.b64decode(match.group(1)))

    def blob(self, number):
        return self.unpack(f"blob{number}")

    def frame(self, view, k):
        """Positions (n x 3), speeds (NaN: not there), quaternions of the polyhedra of frame k."""
        raw = numpy.frombuffer(self.blob(view["frames"] + k), dtype=numpy.uint8).astype(float)
        n, bodies = view["particles"], view["particles"] - view["spheres"]

        def plane(at, count):
            return 256 * raw[at:at + count] + raw[at + count:at + 2 * count]

        low, high = numpy.array(view["low"]), numpy.array(view["high"])
        place = numpy.stack([plane(2 * n * a, n) for a in range(3)], axis=1)
        speed = raw[6 * n:7 * n]
        speed = numpy.where(speed == 255, numpy.nan, view["speed"] * (speed / 254) ** 2)
        turn = numpy.stack([(plane(8 * n + 2 * bodies * c, bodies) - 32767) / 32767
                            for c in range(4)], axis=1) if bodies else numpy.zeros((0, 4))
        return low + (high - low) * place / 65535, speed, turn

    def statics(self, view):
        n, raw = view["particles"], self.blob(view["statics"])
        at, columns = 0, {}
        for name, kind in (("id", "<u4"), ("radius", "<f4"), ("species", "<u2"), ("class", "<u2"),
                           ("shape", "<u2")):
            columns[name] = numpy.frombuffer(raw, dtype=kind, count=n, offset=at)
            at += n * numpy.dtype(kind).itemsize
        return columns
