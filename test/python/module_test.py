"""The Python module beyond what its page shows."""

import ast
import gc
import os
import pathlib
import signal
import sys
import tempfile
import unittest

import numpy as np
import toile

ROOT = pathlib.Path(sys.argv.pop(1))
TUBE = ROOT / "examples" / "tube.xml"


def strip(**changes):
    """A strip 100 x 50 mm of two clamped ends that is pulled along its height in four steps."""
    scene = {
        "title": "Strip",
        "Materials": {"fabric": {"type": "neo-hookean", "C10": 0.1}},
        "Panels": {"strip": {"material": "fabric", "shape": "rectangle", "width": 50.0, "height": 100.0,
                             "elements across": np.int64(4), "elements along": 4}},
        "Supports": {"plane": {"on": ["strip"], "hold": "z"}, "low": {"on": ["strip.bottom"], "hold": "xyz"},
                     "high": {"on": ["strip.top"], "hold": "xyz", "move by": np.array([0.0, 20.0, 0.0])}},
        "Stages": {"pull": {"type": "load", "first step": 0.25, "largest step": 0.25}},
        "Output": {"Points": {"corner": {"on": "strip.top-left"}}},
    }
    scene.update(changes)
    return scene


class Module(unittest.TestCase):
    def test_arrays_outlive_their_session(self):
        """Arrays hold what they view: they have the same values when the session is gone."""
        session = toile.run(str(TUBE))
        arrays = [session.fields["pressure"], session.fields.position, session.blocks[0].connectivity, session.pattern]
        copies = [array.copy() for array in arrays]
        self.assertTrue(all(not array.flags.owndata for array in arrays))
        del session
        gc.collect()
        np.random.rand(1000000)  # takes memory that was freed
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)

    def test_one_state_has_one_memory(self):
        """Asking twice for a field of one state gives the same memory; another state has its own."""
        seen = []
        session = toile.Session(strip())
        session.run(progress=lambda step: seen.append(session.fields["stretch_wale"]))
        self.assertEqual(session.fields["stretch_wale"].ctypes.data, session.fields["stretch_wale"].ctypes.data)
        self.assertGreaterEqual(len(seen), 4)
        means = [field.mean() for field in seen]
        self.assertEqual(means, sorted(means))
        self.assertGreater(means[-1], means[0] + 0.1)

    def test_tables_over_the_steps(self):
        """Reactions and points have a row a step; the pulled end moves by what it is told, and forces balance."""
        session = toile.run(strip())
        self.assertEqual(session.points["corner"].shape, (len(session.steps), 3))
        np.testing.assert_allclose(session.points["corner"][-1], [0.0, 20.0, 0.0], atol=1e-9)
        pull, hold = session.reactions["high"][-1], session.reactions["low"][-1]
        self.assertGreater(pull[1], 1.0)
        np.testing.assert_allclose(pull + hold, np.zeros(3), atol=1e-6)

    def test_callback_that_raises_stops_the_run_and_keeps_its_files(self):
        """What progress raises comes out as it is; the tables and the state up to that step are on disk."""
        with tempfile.TemporaryDirectory() as folder:
            session = toile.Session(strip())

            def progress(step):
                if step.step == 2:
                    raise LookupError("enough")

            with self.assertRaisesRegex(LookupError, "enough"):
                session.run(output=pathlib.Path(folder), progress=progress)
            self.assertEqual([step.step for step in session.steps], [1, 2])
            rows = (pathlib.Path(folder) / "reactions.csv").read_text().splitlines()
            self.assertEqual(len([row for row in rows if not row.startswith("#")]), 3)
            self.assertTrue((pathlib.Path(folder) / "restart.h5").exists())

    def test_interrupt_ends_a_run(self):
        """SIGINT during a run is a KeyboardInterrupt after the current iteration."""
        session = toile.Session(strip())
        with self.assertRaises(KeyboardInterrupt):
            session.run(progress=lambda step: os.kill(os.getpid(), signal.SIGINT) if step.step == 1 else None)
        self.assertLess(len(session.steps), 4)

    def test_errors_have_the_program_s_message_and_kind(self):
        """Input, a stage that fails and a check that does not hold are exceptions of their own with the whole message."""
        with self.assertRaisesRegex(toile.InputError, "nowhere.xml: cannot open this file"):
            toile.Session("nowhere.xml")
        few = strip(Stages={"pull": {"type": "load", "largest step": 0.25, "most steps": 2}})
        session = toile.Session(few)
        with self.assertRaisesRegex(toile.SolveError, 'stage "pull" could not reach its end: it stopped at load'):
            session.run()
        self.assertTrue(0.0 < session.steps[-1].load < 1.0)
        checked = toile.Session({"include": [str(TUBE)], "Checks": {"most": {"quantity": "largest pressure", "upper": 0.1}}})
        with self.assertRaisesRegex(toile.CheckError, 'check "most" does not hold: largest pressure is 0.367'):
            checked.run()
        self.assertGreater(checked.levels["pressure"][0], 0.3)
        self.assertTrue(issubclass(toile.CheckError, toile.Error) and not issubclass(toile.CheckError, toile.InputError))

    def test_warnings_are_python_s(self):
        """What limits the trust in a result is a UserWarning, and in the session."""
        high = {"include": [str(TUBE)], "Output": {"Levels": {"far": {"height": 500.0}}}}
        with self.assertWarnsRegex(UserWarning, "far"):
            session = toile.run(high)
        self.assertTrue(any("far" in warning for warning in session.warnings))
        self.assertTrue(np.isnan(session.levels["pressure"][session.levels["title"].index("far")]))

    def test_values_that_no_scene_holds(self):
        """A value of another type than a scene file has is a TypeError that names the parameter."""
        for value, told in ((None, "NoneType"), (2**40, "too large"), ([1.0, "a"], "numbers or texts"), ([True], "bool")):
            with self.assertRaisesRegex(TypeError, "scene > Body > radius: .*" + told):
                toile.Session({"Body": {"radius": value}})
        with self.assertRaisesRegex(TypeError, "the name 3 is no text"):
            toile.Session({3: {}})

    def test_unknown_field(self):
        """An unknown field is a KeyError that names the nearest one."""
        fields = toile.Session(str(TUBE)).fields
        with self.assertRaisesRegex(KeyError, "did you mean .*pressure"):
            fields["presure"]

    def test_stub_declares_what_there_is(self):
        """toile.pyi has the names of the module and of its classes, and no other; everything has a docstring."""
        stub = ast.parse((ROOT / "apps" / "python" / "toile.pyi").read_text())
        public = {name for name in dir(toile) if not name.startswith("_")}
        types_only = {"Scene", "Sections"}
        declared = {node.name for node in stub.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(declared - types_only, public)
        for node in stub.body:
            if not isinstance(node, ast.ClassDef) or node.name in types_only:
                continue
            there = getattr(toile, node.name)
            self.assertTrue(there.__doc__, node.name)
            if issubclass(there, Exception):
                continue
            members = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            found = {name for name in vars(there) if not name.startswith("_")}
            self.assertEqual({name for name in members if not name.startswith("_")}, found, node.name)
            for name in found:
                self.assertTrue(getattr(there, name).__doc__, f"{node.name}.{name}")


if __name__ == "__main__":
    unittest.main()
