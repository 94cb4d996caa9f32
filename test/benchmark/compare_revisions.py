#!/usr/bin/env python3
"""Runs one scene with two revisions of the program by turns and compares their processor times.

    test/benchmark/compare_revisions.py REVISION SCENE [--runs 9]

REVISION is any name git knows; it is built in build/compare/REVISION. The other side is build/release/toile as it is.
Both sides read the same SCENE, one after the other, so that the machine's moods hit both alike; the first pair only warms
the caches. Prints the medians, their quartiles and the ratio of the medians, per run and per Newton iteration.
"""
import argparse
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def build(revision):
    """Path of the program of a git revision, built without tests."""
    tree = ROOT / "build" / "compare" / revision
    if not tree.exists():
        subprocess.run(["git", "-C", ROOT, "worktree", "add", "--detach", "--quiet", tree, revision], check=True)
    release = tree / "build" / "release"
    subprocess.run(["cmake", "--preset", "release", "-DTOILE_ENABLE_TESTS=OFF", "-DTOILE_ENABLE_BENCHMARKS=OFF"],
                   cwd=tree, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", release, "--target", "toile"], check=True)
    return release / "toile"


def measure(program, scene, folder):
    """Processor time in s and Newton iterations of one run on one core."""
    environment = dict(os.environ, OPENBLAS_NUM_THREADS="1", OMP_NUM_THREADS="1")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([program, "run", scene, "--output", folder], env=environment, text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    iterations = re.search(r"(\d+) Newton iterations", run.stdout)
    if run.returncode != 0 or not iterations:
        sys.exit(f"{program} run {scene} ended with status {run.returncode}:\n{run.stdout}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, int(iterations[1])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("revision")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=9)
    arguments = parser.parse_args()
    sides = {"before": build(arguments.revision), "after": ROOT / "build" / "release" / "toile"}
    seconds = {side: [] for side in sides}
    iterations = {}
    with tempfile.TemporaryDirectory() as folder:
        for number in range(arguments.runs + 1):
            for side, program in sides.items():
                time, iterations[side] = measure(program, arguments.scene.resolve(), os.path.join(folder, side))
                if number > 0:
                    seconds[side].append(time)
            print(f"pair {number} of {arguments.runs}", file=sys.stderr)
    print(f"{'':8}{'run, s':>10}{'quartiles':>18}{'iterations':>12}{'ms each':>10}")
    medians = {}
    for side, times in seconds.items():
        low, medians[side], high = statistics.quantiles(times, n=4)
        print(f"{side:8}{medians[side]:10.3f}{low:10.3f}{high:8.3f}{iterations[side]:12}"
              f"{1e3 * medians[side] / iterations[side]:10.2f}")
    ratio = medians["after"] / medians["before"]
    print(f"after / before: {ratio:.3f} per run, {ratio * iterations['before'] / iterations['after']:.3f} per iteration")


if __name__ == "__main__":
    main()
