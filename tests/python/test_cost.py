"""Cost of the package: time and memory beside C++'s."""

import resource
import time
import unittest

import libcontact
from support import cxx_rows, hip_file, pin_file, python, random_rows

hip = libcontact.Joint.from_file(hip_file)


def seconds(function, times):
    """Processor time of the fastest of some calls."""
    fastest = float("inf")
    for _ in range(times):
        begin = time.thread_time()
        function()
        fastest = min(fastest, time.thread_time() - begin)
    return fastest


class Cost(unittest.TestCase):
    def test_of_many_rows_is_that_of_cxx(self):
        rows = random_rows(100_000)
        both = [
            (seconds(lambda: hip.solve(*rows), 1), cxx_rows(hip_file, *rows)[1])
            for _ in range(4)
        ]
        mine, of_cxx = map(min, zip(*both))
        ratio = mine / of_cxx
        print(f"1e5 rows: {ratio:.3f} of C++")
        self.assertLess(ratio, 1.3)  # 1.02 to 1.16 on busy machines

    def test_of_one_call_is_little(self):
        reaction, rate = random_rows(1)
        call = lambda: [hip.solve(reaction[0], rate[0]) for _ in range(10_000)]
        many = reaction.repeat(10_000, 0), rate.repeat(10_000, 0)
        extra = (seconds(call, 5) - cxx_rows(hip_file, *many, times=5)[1]) / 1e4
        print(f"a call: {extra * 1e6:.2f} us above C++")
        self.assertLess(extra, 10e-6)

    def test_of_importing_is_little(self):
        """Beside Python and NumPy, without which there is none: 1.4 to 1.5 times."""
        code = ("import time, numpy; before = time.process_time(); import libcontact;"
                "print(time.process_time() / before)")  # fmt: skip
        ratio = min(float(python(code).stdout) for _ in range(3))
        print(f"import: {ratio:.2f} of Python with NumPy")
        self.assertLess(ratio, 2)

    def test_of_a_million_calls_is_no_memory(self):
        pin = libcontact.Joint.from_file(pin_file)
        reaction, rate = (rows[0] for rows in random_rows(1))

        def calls(n):
            for _ in range(n):
                pin.solve(reaction, rate).friction_moment
            return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss  # KiB

        before = calls(10_000)
        growth = calls(1_000_000) - before
        print(f"1e6 calls: {growth} KiB more")
        self.assertLess(growth, 1024)


if __name__ == "__main__":
    unittest.main()
