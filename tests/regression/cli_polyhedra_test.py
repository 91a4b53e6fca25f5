#!/usr/bin/python3
"""The program and polyhedra, seen from outside: shapes alone, shapes in scenes, what is counted.

usage: QUERN_PROGRAM=build/release/quern cli_polyhedra_test.py [CLASS ...]
"""

import itertools
import re
import struct
import unittest

from cli_test import APPS, LAW, Case, quern

CUBE = (APPS / "shapes" / "cube.stl").read_text(encoding="utf-8")
TAKES_HULL = "; hull = true (quern shape: --hull) takes its convex hull"


def box(low=(0, 0, 0), high=(1, 1, 1)):
    """Twelve triangles, outwards."""
    triangles = []
    for axis, side in itertools.product(range(3), (0, 1)):
        square = []
        for u, v in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [0, 0, 0]
            corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, u, v
            square.append(tuple((low, high)[c][k] for k, c in enumerate(corner)))
        if side == 0:
            square.reverse()
        triangles += [(square[0], square[1], square[2]), (square[0], square[2], square[3])]
    return triangles


def dented():
    """A cube whose top sinks to a point halfway down."""
    triangles = [t for t in box() if any(corner[2] == 0 for corner in t)]
    rim = [(0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    return triangles + [(rim[k], rim[(k + 1) % 4], (0.5, 0.5, 0.5)) for k in range(4)]


def ascii_stl(triangles):
    lines = ["solid shape"]
    for triangle in triangles:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex {:.9g} {:.9g} {:.9g}".format(*corner) for corner in triangle]
        lines += ["endloop", "endfacet"]
    return ("\n".join(lines) + "\nendsolid shape\n").encode()


def binary_stl(triangles, header):
    body = [struct.pack("<12fH", 0, 0, 0, *itertools.chain(*t), 0) for t in triangles]
    return header.ljust(80) + struct.pack("<I", len(body)) + b"".join(body)


class Shapes(Case):
    def shape(self, *arguments):
        return quern("shape", *arguments, "--out", self.out)

    def file(self, name, contents):
        path = self.folder / name
        path.write_bytes(contents)
        return path

    def test_are_described_and_written_as_a_frame(self):
        self.expect(0, self.shape(APPS / "shapes" / "ore12.stl"), "40 triangles, 22 vertices",
                    "12 faces, 20 vertices, 30 edges; 2 spare vertices dropped", "closed",
                    "equivalent diameter  1\n", "inertia", "principal axes", "bound radius",
                    "inner radius", "elongation", "flatness")
        self.assertGreater((self.out / "ore12.hdf").stat().st_size, 0)

    def test_that_are_no_body_end_with_2_unless_their_hull_is_asked_for(self):
        first = CUBE[CUBE.index("facet"):CUBE.index("endfacet") + len("endfacet\n")]
        broken = self.file("open.stl", CUBE.replace(first, "").encode())
        self.expect(2, self.shape(broken), "open.stl: not closed: 3 edges", "hull = true")
        self.assertFalse(self.out.exists())
        self.expect(0, self.shape(broken, "--hull"), "warning:", "6 faces, 8 vertices, 12 edges")

    def test_of_unreadable_files_end_with_2(self):
        self.expect(2, self.shape(self.folder / "no.stl"), "no.stl", "cannot read the mesh")

    def refused(self, contents, *message):
        path = self.file("rock.stl", contents)
        result = self.expect(2, self.shape(path), *message)
        self.assertTrue(result.stderr.startswith((f"error: {path}: ", f"{path}:")), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1)
        self.assertEqual(result.stdout, "")
        self.assertFalse(self.out.exists())

    def test_that_are_broken_have_each_its_message(self):
        two = box() + box((3, 0, 0), (4, 1, 1))
        edge = box() + box((-1, -1, 0), (0, 0, 1))
        flat = [[(x, y, 1e-7 * z) for x, y, z in t] for t in box()]
        self.refused(ascii_stl(box()[1:]), "not closed: 3 edges with one triangle only", TAKES_HULL)
        self.refused(ascii_stl(edge), "not a simple surface: 1 edge with more than two triangles",
                     TAKES_HULL)
        self.refused(ascii_stl(dented()), "not convex: bent inwards by",
                     "its hull has 1.2 times its volume", TAKES_HULL)
        self.refused(ascii_stl(two), "has 2 separate bodies, a shape is one", TAKES_HULL)
        self.refused(ascii_stl(flat), "flat: ")
        self.refused(ascii_stl([]), "the mesh has no triangles")
        self.refused(ascii_stl(box()[:1]), "the mesh has 1 triangle, a body needs at least 4")
        self.refused(b"", "the file is empty")
        self.refused(ascii_stl(box()).replace(b"vertex 1 1 1", b"vertex 1 nan 1", 1), "nan")
        nan = [((0, 0, 0), (float("nan"), 0, 0), (0, 1, 0))] + box()
        self.refused(binary_stl(nan, b"rock"), "triangle 1, corner 2", "is NaN, not a finite number")

    def test_in_binary_files_that_begin_with_solid_are_read(self):
        path = self.file("rock.stl", binary_stl(box(), b"solid rock"))
        self.expect(0, self.shape(path), "12 triangles, 8 vertices", "6 faces, 8 vertices")


# Rocks without gravity, in a domain of their own.
ROCK = """format = 1
[run]
duration = "1 ms"
time_step = "1e-5 s"
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[domain]
low = ["-1 m", "-1 m", "-1 m"]
high = ["1 m", "1 m", "1 m"]
""" + LAW + """[[walls]]
name = "floor"
material = "ore"
point = ["0 m", "0 m", "-0.5 m"]
normal = [0, 0, 1]
[[particles]]
name = "rock"
material = "ore"
shape = "polyhedron"
mesh = %s
entries = [%s]
"""
ENTRY = ('{ position = ["%g m", "0 m", "%g m"], diameter = "%g m", '
         'orientation = { axis = [0, 0, 1], angle = "0 deg" } }')


class PolyhedronCase(Case):
    def scene(self, mesh, *entries, more=""):
        path = self.folder / "rock.toml"
        rows = [ENTRY % entry for entry in entries or [(0, 0, 0.1)]]
        path.write_text(ROCK % (mesh, ", ".join(rows)) + more, encoding="utf-8")
        return path

    def run_scene(self, scene, *more):
        return quern("run", scene, "--out", self.out, "--threads", 1, *more)


class ShapesInScenes(PolyhedronCase):
    def setUp(self):
        super().setUp()
        (self.folder / "dented.stl").write_bytes(ascii_stl(dented()))
        (self.folder / "open.stl").write_bytes(ascii_stl(box()[1:]))

    def place(self, scene, text):
        """file:line:column of a text in the scene."""
        before = scene.read_text(encoding="utf-8").partition(text)[0]
        return f"{scene}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"

    def test_that_are_broken_are_told_with_their_place_in_the_scene(self):
        scene = self.scene('"open.stl"')
        for command in ("run", "check"):
            result = self.expect(2, quern(command, scene, cwd=self.folder))
            self.assertTrue(result.stderr.startswith(
                f"{self.place(scene, chr(34) + 'open.stl')}: error: 'mesh': "
                f"{self.folder / 'open.stl'}: not closed: 3 edges"), result.stderr)

    def test_that_are_broken_are_told_each_with_its_place_in_a_list(self):
        scene = self.scene('["open.stl",\n  "dented.stl"]')
        lines = self.expect(2, self.run_scene(scene)).stderr.splitlines()
        self.assertEqual(len(lines), 2, lines)
        for line, name, message in zip(lines, ("open.stl", "dented.stl"),
                                       ("not closed", "not convex")):
            place = self.place(scene, f'"{name}"')
            self.assertTrue(line.startswith(f"{place}: error: 'mesh': {self.folder / name}: {message}"),
                            line)

    def test_of_unreadable_meshes_are_told_with_their_place_in_both_files(self):
        (self.folder / "cut.stl").write_bytes(ascii_stl(box())[:200])
        scene = self.scene('"cut.stl"', more='[[walls]]\nname = "liner"\nmaterial = "ore"\n'
                           'mesh = "./cut.stl"\n')
        said = self.expect(2, self.run_scene(scene)).stderr
        for text in ('"cut.stl"', '"./cut.stl"'):
            self.assertRegex(said, re.escape(f"{self.place(scene, text)}: error: 'mesh': "
                                             f"{self.folder / 'cut.stl'}:") + r"\d+:\d+: ")

    def test_set_on_the_command_line_are_told_as_such(self):
        scene = self.scene('"dented.stl"')
        result = self.run_scene(scene, "--set", "particles.rock.mesh=open.stl")
        self.expect(2, result, "--set particles.rock.mesh=open.stl: error: 'mesh': ")

    def test_are_taken_by_their_hull_on_request(self):
        scene = self.scene('"dented.stl"\nhull = true')
        self.expect(0, self.run_scene(scene), "warning:", "dented.stl: not convex",
                    "its hull was taken", "the hull has 1.2 times the volume of the mesh")
        self.assertEqual(self.summary()["polyhedra"], 1)
        # The mass is that of the hull with the equivalent diameter asked for.
        self.assertAlmostEqual(self.summary()["total_mass_kg"], 4500 * 3.14159265 / 6 * 1e-3,
                               delta=1e-6)


class Fallbacks(PolyhedronCase):
    """What the narrow phase cannot do as it is defined is counted and warned of."""

    def setUp(self):
        super().setUp()
        (self.folder / "cube.stl").write_text(CUBE, encoding="utf-8")

    def counts(self):
        summary = self.summary()
        return tuple(summary[kind + "_warnings"] for kind in ("contained", "bounded", "wall_depth"))

    def test_a_body_within_another_is_warned_of_and_stops_the_run(self):
        scene = self.scene('"cube.stl"', (0, 0, 0.2), (0.01, 0, 0.04))
        self.expect(4, self.run_scene(scene), "warning: contacts of polyhedra", "1 of a body within "
                    "another", "error:", "an overlap reached")
        self.assertEqual(self.counts(), (1, 0, 0))
        self.assertGreater(self.summary()["overlap_warnings"], 0)

    def test_a_deep_wall_is_counted_in_each_step_and_across_a_resume(self):
        # Its lowest corners are 85 mm below the floor, its inner radius is 81 mm.
        scene = self.scene('"cube.stl"', (0, -0.504, 0.2))
        self.expect(0, self.run_scene(scene), "warning: contacts of polyhedra",
                    "deeper in a wall than it is taken to be thick (summed over steps)")
        straight = self.counts()
        self.assertEqual(straight[:2], (0, 0))
        self.assertGreater(straight[2], 20)
        self.out = self.folder / "stopped"
        self.expect(0, self.run_scene(scene, "--until", "1e-4"))
        self.assertEqual(self.counts(), (0, 0, 10))
        self.expect(0, quern("resume", self.out, "--threads", 1))
        self.assertEqual(self.counts(), straight)
        start, self.out = self.out, self.folder / "from_file"
        self.expect(0, self.run_scene(scene, "--set", "run.start=file", "--set",
                                      f"run.start_file={start}", "--until", "5e-5"))
        self.assertEqual(self.counts(), (0, 0, 5))  # another run counts anew

    def test_nothing_is_said_where_nothing_was_counted(self):
        result = self.expect(0, self.run_scene(self.scene('"cube.stl"')))
        self.assertNotIn("contacts of polyhedra", result.stderr)
        self.assertEqual(self.counts(), (0, 0, 0))


if __name__ == "__main__":
    unittest.main()
