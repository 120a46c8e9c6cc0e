"""The lines of the pages in which pandas stands, as they stand there."""

import os
import re
import tempfile
import textwrap
import unittest
from pathlib import Path

import libcontact
import numpy as np
from support import hip_file, program, random_rows, source


class Pages(unittest.TestCase):
    def test_results_become_a_frame(self):
        line = re.search(
            r"`(pandas\.DataFrame.*?)`",
            (source / "libcontact/docs/reference/python.md").read_text())[1]
        hip = libcontact.Joint.from_file(hip_file)
        s = hip.solve(*(a.reshape(2, 3, 3) for a in random_rows(6)))
        frame = eval("__import__('pandas')" + line.removeprefix("pandas"), {"s": s})
        self.assertEqual(len(frame), 6)
        self.assertEqual(list(frame), list(s.to_dict()))
        np.testing.assert_array_equal(frame.half_angle, s.half_angle.ravel())
        np.testing.assert_array_equal(
            frame.friction_moment_z, s.friction_moment[..., 2].ravel())

    def test_journals_become_a_frame(self):
        page = (source / "libcontact/docs/reference/hinge-study.md").read_text()
        lines = re.search(r"    import pandas, sqlite3\n(    .*\n)*", page)[0]
        journal = re.search(r'connect\("(.*?)"\)', lines)[1]
        study = source / "data/studies/lined_bearing.toml"
        before = Path.cwd()
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                _, wrong = program(
                    "hinge-study", study, "--runs", "9", "--journal",
                    Path(folder) / journal, "--csv", Path(folder) / "rows.csv")
                self.assertEqual(wrong, "")
                names = {}
                exec(textwrap.dedent(lines), names)
            finally:
                os.chdir(before)
            said = np.genfromtxt(
                Path(folder) / "rows.csv", delimiter=",", names=True,
                deletechars="")["M_t_N_m"]
        rows = names["rows"].sort_values("run")
        np.testing.assert_array_equal(rows.M_t_N_m, said)
        self.assertEqual(len(rows), 10)


if __name__ == "__main__":
    unittest.main()
