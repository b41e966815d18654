"""The floating-point peer of proximity in Python: coal, which was FCL.

usage: proximity.py distance|relation|penetration|depths A B PLACEMENTS LEAST SECONDS

A and B are OFF files, whose fractions become the nearest doubles; PLACEMENTS has a translation of B a line. Prints one JSON object on
one line, read by `cargo xtask peers proximity`: processor nanoseconds of a query, the median of at least LEAST passes over all
placements and of about SECONDS. The call from Python is part of a query; `call` is what a call that does nothing takes. `depths` is not
timed: it prints the depth for each placement.
"""

import json
import os
import statistics
import struct
import sys
import time
from fractions import Fraction
from importlib.metadata import version

os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

import coal  # noqa: E402  (the thread pools are made at import)
import numpy as np  # noqa: E402


def hull(name):
    """The hull of the vertices of an OFF file."""
    with open(name, encoding="ascii") as file:
        words = iter([word for line in file for word in line.split("#")[0].split()])
    if next(words) != "OFF":
        raise ValueError(f"no OFF header in {name}")
    vertices, _, _ = (int(next(words)) for _ in range(3))
    points = coal.StdVec_Vec3s()
    for _ in range(vertices):
        points.append(np.array([float(Fraction(next(words))) for _ in range(3)]))
    return coal.ConvexBase.convexHull(points, True, "Qt")


def read_placements(name):
    """The translations, and the hash of the bits of all numbers in order."""
    placements, folded = [], 0xCBF29CE484222325
    with open(name, encoding="ascii") as file:
        for line in file:
            numbers = [float(word) for word in line.split()]
            if len(numbers) != 3:
                raise ValueError(f"no placement: {line.strip()}")
            for number in numbers:
                bits = struct.unpack("<Q", struct.pack("<d", number))[0]
                folded = ((folded ^ bits) * 0x100000001B3) % 2**64
            placements.append(np.array(numbers))
    return placements, folded


def queries(a, b):
    """For each question a function of a translation."""
    fixed, moved = coal.Transform3s(), coal.Transform3s()
    ask_distance, distance = coal.DistanceRequest(), coal.DistanceResult()
    ask_contact, contact = coal.CollisionRequest(), coal.CollisionResult()

    def nothing(translation):
        moved.setTranslation(translation)
        distance.clear()
        return 0.0

    def signed_distance(translation):
        moved.setTranslation(translation)
        distance.clear()
        return coal.distance(a, fixed, b, moved, ask_distance, distance)

    def collide(translation):
        moved.setTranslation(translation)
        contact.clear()
        return float(coal.collide(a, fixed, b, moved, ask_contact, contact) > 0)

    def depth(translation):
        return -signed_distance(translation)

    return {"distance": signed_distance, "relation": collide, "penetration": depth, "depths": depth, "": nothing}


def measured(query, placements, least, budget):
    """Processor nanoseconds of a query, the number of passes, and the sum of all answers."""
    times, total = [], 0.0
    while len(times) < least or (sum(times) < budget and len(times) < 2000):
        begin = time.process_time()
        total = 0.0
        for placement in placements:
            total += query(placement)
        times.append(time.process_time() - begin)
    return statistics.median(times) * 1e9 / len(placements), len(times), total


def main():
    name, a, b, places, least, budget = sys.argv[1:7]
    placements, folded = read_placements(places)
    known = queries(hull(a), hull(b))
    record = {"method": "coal", "version": f"coal {version('coal')}", "input_hash": f"{folded:016x}"}
    if name == "depths":
        record["depths"] = [known[name](placement) for placement in placements]
    else:
        nanoseconds, passes, total = measured(known[name], placements, int(least), float(budget))
        record |= {"placements": len(placements), "repetitions": passes, "nanoseconds": nanoseconds, "sum": total}
        record["call"], _, _ = measured(known[""], placements, 3, 0.0)
    print(json.dumps(record))


if __name__ == "__main__":
    main()
