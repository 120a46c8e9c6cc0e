"""Studies on executors: threads here, Dask and MPI where they are installed."""

import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import unittest.mock
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import libcontact.study

ROOT = Path(__file__).parents[2]
DATA = ROOT / "data"
os.environ["PATH"] = f"{os.environ['CONTACT_BUILD']}/bin:{os.environ['PATH']}"

JOINT = f"""
name = "ball"
kind = "ball"
geometry = {{ radius_mm = 50, radial_clearance_um = 100 }}
materials = {{ pair = "{DATA}/materials/steel_steel.toml" }}
friction = {{ coefficient = 0.1 }}
pressure = {{ law = "sqrt_tan" }}
"""
# Stand-in for sbatch: runs the tasks of a job array one after another.
SBATCH = """#!/bin/sh
for i in $(seq $(echo ${1#--array=} | tr - ' ')); do
  SLURM_ARRAY_TASK_ID=$i sh -c "$3" || exit
done
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
        self.study = self.folder / "study.toml"
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

    def mpi(self, executor="MPIPoolExecutor"):
        """Status and table of a job on MPI; its rows are in mpi.csv."""
        script = self.folder / "run.py"
        script.write_text(f"""
import signal
from mpi4py.futures import MPIPoolExecutor
import libcontact.study

class Losing(MPIPoolExecutor):
    def submit(self, function, *arguments):
        if arguments[-1] == "250:299":
            return super().submit(signal.raise_signal, signal.SIGKILL)
        return super().submit(function, *arguments)

if __name__ == "__main__":
    with {executor}() as executor:
        print(libcontact.study.run("{self.study}", executor,
                                   ["--csv", "{self.folder}/mpi.csv"],
                                   part=50, folder="{self.folder}/mpi"), end="")
""")
        done = subprocess.run(
            ["mpiexec", "--allow-run-as-root", "--oversubscribe", "-n", "3",
             sys.executable, "-m", "mpi4py.futures", str(script)],
            text=True, capture_output=True, timeout=60)
        return done.returncode, done.stdout

    @unittest.skipUnless("mpi" in sys.argv, "asked for by name")
    def test_mpi(self):
        csv = self.folder / "mpi.csv"
        status, table = self.mpi()
        self.assertEqual(status, 0)
        self.assertEqual((table, csv.read_bytes()), self.serial)

    @unittest.skipUnless("mpi" in sys.argv, "asked for by name")
    def test_mpi_with_a_rank_that_is_lost(self):
        csv = self.folder / "mpi.csv"
        status, _ = self.mpi("Losing")
        self.assertNotEqual(status, 0)
        self.assertFalse(csv.exists())
        kept = {file: file.stat().st_mtime_ns
                for file in (self.folder / "mpi").glob("*-*")
                if file.suffix != ".unfinished"}
        self.assertIn(len(kept), range(1, 9))
        status, table = self.mpi()
        self.assertEqual((table, csv.read_bytes()), self.serial)
        for file, time_ns in kept.items():
            self.assertEqual(file.stat().st_mtime_ns, time_ns)

    def recipe(self, *marks):
        """Runs the lines of the page that have these words."""
        page = (ROOT / "libcontact/docs/reference/hinge-study.md").read_text().splitlines()
        lines = [next(line for line in page if mark in line) for mark in marks]
        for line in lines:
            subprocess.run(["sh", "-ec", line], cwd=self.folder, check=True,
                           capture_output=True)
        return lambda folder, options: self.alone(
            folder, [*options, "--merge", *map(str, self.folder.glob("part*"))])

    @unittest.skipUnless("parallel" in sys.argv, "asked for by name")
    def test_gnu_parallel(self):
        merge = self.recipe("| parallel")
        self.assertEqual(len(list(self.folder.glob("part*"))), 5)
        self.assertEqual(self.results("parallel", merge), self.serial)

    def test_slurm_array(self):
        sbatch = self.folder / "sbatch"
        sbatch.write_text(SBATCH)
        sbatch.chmod(0o755)
        with unittest.mock.patch.dict(
                os.environ, PATH=f"{self.folder}:{os.environ['PATH']}"):
            merge = self.recipe(">ranges", "sbatch")
        self.assertEqual(len(list(self.folder.glob("part*"))), 5)
        self.assertEqual(self.results("slurm", merge), self.serial)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
