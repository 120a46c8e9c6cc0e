"""Studies on executors: threads here, Dask and MPI where they are installed."""

import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import libcontact.study

DATA = Path(__file__).parents[2] / "data"
os.environ["PATH"] = f"{os.environ['CONTACT_BUILD']}/bin:{os.environ['PATH']}"

JOINT = f"""
name = "ball"
kind = "ball"
geometry = {{ radius_mm = 50, radial_clearance_um = 100 }}
materials = {{ pair = "{DATA}/materials/steel_steel.toml" }}
friction = {{ coefficient = 0.1 }}
pressure = {{ law = "sqrt_tan" }}
"""
STUDY = """
name = "balls"
joint = "j.toml"
runs = 400
load = { reaction_kN = 100 }
[[requirement]]
quantity = "M_t_N_m"
at_most = 700
success = 0.99
[[dispersion]]
key = "friction.coefficient"
kind = "uniform"
low = 0.05
high = 0.15
"""


class Executors(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        (self.folder / "j.toml").write_text(JOINT)
        self.study = self.folder / "s.toml"
        self.study.write_text(STUDY)
        self.serial = self.results("serial", self.alone)

    def results(self, name, run):
        """The table and the rows' bytes."""
        csv = self.folder / f"{name}.csv"
        text = run(self.folder / name, ["--csv", str(csv)])
        return text, csv.read_bytes()

    def alone(self, folder, options):
        done = subprocess.run(
            ["hinge-study", str(self.study), "--journal", str(folder), *options],
            text=True, capture_output=True, check=True)
        return done.stdout

    def by(self, executor):
        return lambda folder, options: libcontact.study.run(
            self.study, executor, options, part=50, folder=folder)

    def test_threads(self):
        with ThreadPoolExecutor(2) as executor:
            self.assertEqual(self.results("threads", self.by(executor)), self.serial)

    def test_parts_that_are_done_are_kept(self):
        class Once(ThreadPoolExecutor):
            def submit(self, *arguments):
                submitted.append(arguments[-1])
                return super().submit(*arguments)

        submitted = []
        with Once(1) as executor:
            self.results("kept", self.by(executor))
            self.assertEqual(len(submitted), 9)
            (self.folder / "kept" / "50-99").unlink()
            self.assertEqual(self.results("kept", self.by(executor)), self.serial)
        self.assertEqual(submitted[9:], ["50:99"])

    def test_refused(self):
        self.study.write_text(STUDY.replace("uniform", "gauss"))
        with ThreadPoolExecutor(1) as executor:
            with self.assertRaisesRegex(libcontact.Error, "kind = \"gauss\" must be"):
                libcontact.study.run(self.study, executor, folder=self.folder / "x")

    @unittest.skipUnless("dask" in sys.argv, "asked for by name")
    def test_dask_with_a_worker_that_is_killed(self):
        from distributed import Client, LocalCluster

        with LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                          dashboard_address=None) as cluster, Client(cluster) as client:
            victims = [w.process.pid for w in cluster.workers.values()]

            def kill():
                time.sleep(0.3)
                os.kill(victims[0], 9)

            killer = threading.Thread(target=kill)
            killer.start()
            self.assertEqual(
                self.results("dask", self.by(client.get_executor())), self.serial)
            killer.join()

    @unittest.skipUnless("mpi" in sys.argv, "asked for by name")
    def test_mpi(self):
        csv = self.folder / "mpi.csv"
        script = self.folder / "run.py"
        script.write_text(f"""
from mpi4py.futures import MPIPoolExecutor
import libcontact.study
if __name__ == "__main__":
    with MPIPoolExecutor() as executor:
        print(libcontact.study.run("{self.study}", executor, ["--csv", "{csv}"],
                                   part=50, folder="{self.folder}/mpi"), end="")
""")
        done = subprocess.run(
            ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3",
             sys.executable, "-m", "mpi4py.futures", str(script)],
            text=True, capture_output=True, check=True)
        self.assertEqual((done.stdout, csv.read_bytes()), self.serial)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
