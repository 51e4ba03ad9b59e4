#!/usr/bin/env python3
"""Plays the same shots in pooltool and in Massé and prints what each costs.

    scripts/compare_pooltool.py [--folder FOLDER] [--seconds S] [--version VERSION]

Needs Python 3.10 to 3.13, cargo and a network: pooltool is installed from PyPI into a virtual environment in FOLDER,
which is kept for the next run; without --folder it is a temporary one. `examples/time_shots.rs` times Massé and tells
the scenes; this script builds the same tables, balls and strokes in pooltool and times them, in one go on one machine.
"""

import argparse
import importlib.metadata
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent

DIFFERENCES = """\
What is the same: table (noses, facings, jaws, pockets), balls, places, cue, stroke, cloth, the friction and restitution
of balls, Stronge's compliant cushion with its parameters.
What differs: where a cushion touches a ball (Massé on the ball's surface at the height of the nose, pooltool along the
line to the nose from a ball one radius away), how throw is capped where the balls cease to slip, which event comes first
of several at one time, and that pooltool tests each cushion line from the side of play only. After a dozen hits the two
are different shots of the same kind, so events per second are the fairer measure of the breaks.
Times: one whole simulation from the scene to the last event, events recorded. Massé: processor time of its thread, mean
of all repetitions (where the system does not tell it: median of the elapsed times). pooltool: time.process_time, median,
after a warm-up that compiles its kernels."""


def create(folder, version):
    """The interpreter of a virtual environment in which pooltool can be imported."""
    import venv

    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if not python.exists():
        venv.create(folder, with_pip=True)
    if runs(python, "import pooltool"):
        return python
    pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    wanted = f"pooltool-billiards=={version}"
    print(f"installing {wanted} in {folder}; this takes some minutes", file=sys.stderr)
    # Its graphics may ask for a build of panda3d that PyPI does not have; the simulation takes any.
    subprocess.run([*pip, "--no-deps", wanted], check=True)
    asked = subprocess.run(
        [str(python), "-c", "import importlib.metadata as m; print('\\n'.join(m.requires('pooltool-billiards')))"],
        check=True,
        capture_output=True,
        text=True,
    ).stdout.splitlines()
    needed = [line for line in asked if not line.startswith("panda3d==") and "extra ==" not in line]
    needed = [line for line in needed if not line.startswith("panda3d>=")] + ["panda3d>=1.10.13"]
    subprocess.run([*pip, *needed], check=True)
    if not runs(python, "import pooltool"):
        sys.exit("pooltool is installed but cannot be imported")
    return python


def runs(python, code):
    return subprocess.run([str(python), "-c", code], capture_output=True, env=quiet(python)).returncode == 0


def quiet(python):
    """An environment in which pooltool writes its settings beside the virtual environment and not in the home folder."""
    home = str(pathlib.Path(python).parent.parent / "home")
    os.makedirs(home, exist_ok=True)
    return {**os.environ, "HOME": home, "XDG_CONFIG_HOME": home}


def time_ours(seconds):
    command = ["cargo", "run", "--quiet", "--release", "--no-default-features", "--example", "time_shots", "--"]
    done = subprocess.run([*command, str(seconds)], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(done.stdout)


def theirs(vector):
    """Ours is x along, y up, z across; theirs x across, y along, z up: a rotation."""
    return [vector[2], vector[0], vector[1]]


def side_of_play(start, end, pockets):
    """A point on the side of a cushion line where balls are: the middle of the table for a nose, the nearest pocket for a
    facing, which stands askew."""
    if start[0] == end[0] or start[1] == end[1] or not pockets:
        return [0.0, 0.0]
    middle = [(start[0] + end[0]) / 2, (start[1] + end[1]) / 2]
    return min(
        (pocket["center"] for pocket in pockets),
        key=lambda center: (center[0] - middle[0]) ** 2 + (center[1] - middle[1]) ** 2,
    )


def table_of(scene, numpy, components, Table, TableType):
    """The table of a scene, its origin moved to a corner."""
    ours = scene["table"]
    height = ours["nose_height"]

    def place(plan, up):
        return numpy.array([plan[1] + ours["width"] / 2, plan[0] + ours["length"] / 2, up], dtype=float)

    linear, circular = {}, {}
    names = outer_names(ours)
    for i, cushion in enumerate(ours["cushions"]):
        if "Line" in cushion:
            start, end = cushion["Line"]["from"], cushion["Line"]["to"]
            name = names.get(i, f"l{i}")
            inside = place(side_of_play(start, end, ours["pockets"]), height)
            p1, p2 = place(start, height), place(end, height)
            linear[name] = components.LinearCushionSegment(name, p1=p1, p2=p2, direction=direction(p1, p2, inside, components))
        else:
            arc = cushion["Arc"]
            name = f"a{i}"
            circular[name] = components.CircularCushionSegment(name, center=place(arc["center"], height), radius=arc["radius"])
    pockets = {
        pocket["name"]: components.Pocket(pocket["name"], center=place(pocket["center"], 0.0), radius=pocket["radius"])
        for pocket in ours["pockets"]
    }
    kind = TableType.POCKET if pockets else TableType.BILLIARD
    return Table(components.CushionSegments(linear=linear, circular=circular), pockets, kind)


def outer_names(table):
    """pooltool measures a table by the lines 3, 12 (sides), 9 and 18 (ends)."""
    names = {}
    lines = [(i, c["Line"]) for i, c in enumerate(table["cushions"]) if "Line" in c]
    x, z = table["length"] / 2, table["width"] / 2
    for name, axis, value in (("3", 1, -z), ("12", 1, z), ("9", 0, x), ("18", 0, -x)):
        for i, line in lines:
            if i not in names and line["from"][axis] == line["to"][axis] == value:
                names[i] = name
                break
    return names


def direction(p1, p2, inside, components):
    """Which of pooltool's two sides of a line a point is on. pooltool has the line as lx x + ly y + l0 = 0; a ball on the
    side where that is negative has its centre at distance R on the first side."""
    sides = components.CushionDirection
    if p2[0] == p1[0]:
        lx, ly, l0 = 1.0, 0.0, -p1[0]
    else:
        lx = -(p2[1] - p1[1]) / (p2[0] - p1[0])
        ly = 1.0
        l0 = -p1[1] - lx * p1[0]
    return sides.SIDE1 if lx * inside[0] + ly * inside[1] + l0 < 0 else sides.SIDE2


def system_of(scene):
    import numpy
    import pooltool
    from pooltool.objects.ball.datatypes import Ball, BallParams, BallState
    from pooltool.objects.cue.datatypes import Cue, CueSpecs
    from pooltool.objects.table import components
    from pooltool.objects.table.datatypes import Table
    from pooltool.objects.table.specs import TableType

    laws = scene["laws"]
    cloth, cushion = laws["motion"]["Coulomb"], laws["cushion"]["Stronge2018"]
    corner = [scene["table"]["width"] / 2, scene["table"]["length"] / 2, 0.0]
    balls = {}
    for ours in scene["balls"]:
        state, constants = ours["state"], ours["ball"]
        params = BallParams(
            m=constants["mass"],
            R=constants["radius"],
            u_s=cloth["sliding"],
            u_r=cloth["rolling"],
            u_sp_proportionality=cloth["spin_deceleration"] / (2.5 * cloth["gravity"]),
            e_b=laws["ball_ball"]["Frictional"]["restitution"],
            e_c=cushion["restitution"],
            f_c=cushion["friction"],
            g=cloth["gravity"],
        )
        position = [a + b for a, b in zip(theirs(state["position"]), corner)]
        rvw = numpy.array([position, theirs(state["velocity"]), theirs(state["angular_velocity"])], dtype=float)
        moves = any(state["velocity"]) or any(state["angular_velocity"])
        sliding = pooltool.constants.sliding if moves else pooltool.constants.stationary
        balls[ours["name"]] = Ball(id=ours["name"], state=BallState(rvw, sliding), params=params)
    planned, cue = scene["shot"], scene["cue"]
    specs = CueSpecs(M=cue["mass"], end_mass=cue["end_mass"])
    if planned is None:
        stick = Cue(V0=0.0, cue_ball_id=scene["balls"][0]["name"], specs=specs)
    else:
        shot = planned["shot"]
        stick = Cue(
            V0=shot["speed"],
            phi=shot["heading"] * 180 / numpy.pi + 90,
            theta=shot["elevation"] * 180 / numpy.pi,
            a=-shot["side"],
            b=shot["height"],
            cue_ball_id=scene["balls"][planned["ball"]]["name"],
            specs=specs,
        )
    table = table_of(scene, numpy, components, Table, TableType)
    return pooltool.System(cue=stick, table=table, balls=balls)


def engine():
    """pooltool's default physics, whatever settings lie about."""
    from pooltool.physics.engine import PhysicsEngine
    from pooltool.physics.resolve import resolver

    return PhysicsEngine(resolver=resolver.default_resolver())


def time_theirs(timings, seconds):
    """Runs inside the virtual environment."""
    import pooltool
    from pooltool.events import EventType

    physics = engine()
    found = []
    for timing in timings:
        scene = timing["scene"]
        system = system_of(scene)
        limit = scene["time_limit"] if scene["shot"] is None else None
        row = {"name": timing["name"]}
        try:
            simulate(pooltool, system, physics, limit and 0.01)  # compiles
            times = []
            while sum(times) < seconds or (len(times) < 3 and sum(times) < 5.0):
                begun = time.process_time()
                played = simulate(pooltool, system, physics, limit)
                times.append(time.process_time() - begun)
            events = [event for event in played.events if event.event_type != EventType.NONE]
            row |= {
                "seconds": statistics.median(times),
                "repetitions": len(times),
                "events": len(events),
                "first": [[event.time, str(event.event_type), list(event.ids)] for event in events[:4]],
                "end_time": float(played.t),
            }
        except Exception as error:  # a shot that it cannot play is a result too
            row["error"] = f"{type(error).__name__}: {error}"
        found.append(row)
    return {"version": importlib.metadata.version("pooltool-billiards"), "shots": found}


def simulate(pooltool, system, physics, limit):
    return pooltool.simulate(system, engine=physics, t_final=limit)


def told(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e6:.3g} us"


def report(ours, peer):
    print(f"pooltool {peer['version']} and Massé on {platform.machine()}, {os.cpu_count()} cores, {platform.python_version()}\n")
    form = "{:<28}{:>14}{:>9}{:>12}{:>14}{:>9}{:>13}{:>10}{:>17}"
    print(form.format("shot", "pooltool", "events", "events/s", "Massé", "events", "events/s", "faster", "events/s ratio"))
    for mine, yours in zip(ours, peer["shots"]):
        seconds = mine["processor_seconds_mean"] or mine["seconds"]
        rate = mine["events"] / seconds
        if "error" in yours:
            print(f"{mine['name']:<28}pooltool fails: {yours['error']}; Massé {told(seconds)}, {rate:,.0f} events/s")
            continue
        their_rate = yours["events"] / yours["seconds"]
        print(
            form.format(
                mine["name"],
                told(yours["seconds"]),
                yours["events"],
                f"{their_rate:,.0f}",
                told(seconds),
                mine["events"],
                f"{rate:,.0f}",
                f"{yours['seconds'] / seconds:,.0f}x",
                f"{rate / their_rate:,.0f}x",
            )
        )
    print(f"\n{DIFFERENCES}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--folder", type=pathlib.Path, help="folder of the virtual environment, kept for the next run")
    parser.add_argument("--seconds", type=float, default=2.0, help="least processor time for each shot and program")
    parser.add_argument("--version", default="0.6.0", help="version of pooltool-billiards (default 0.6.0)")
    parser.add_argument("--json", type=pathlib.Path, help="file for all numbers")
    parser.add_argument("--inside", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.inside:
        json.dump(time_theirs(json.load(sys.stdin), options.seconds), sys.stdout)
        return
    with tempfile.TemporaryDirectory() as temporary:
        folder = options.folder or pathlib.Path(temporary)
        try:
            python = create(folder.absolute(), options.version)
        except subprocess.CalledProcessError as error:
            sys.exit(f"pooltool cannot be installed in {folder}: {error}")
        ours = time_ours(options.seconds)
        done = subprocess.run(
            [str(python), str(pathlib.Path(__file__).resolve()), "--inside", "--seconds", str(options.seconds)],
            input=json.dumps(ours),
            stdout=subprocess.PIPE,
            text=True,
            check=True,
            env=quiet(python),
        )
        peer = json.loads(done.stdout[done.stdout.index("{") :])
    report(ours, peer)
    if options.json:
        options.json.write_text(json.dumps({"masse": ours, "pooltool": peer}, indent=1))


if __name__ == "__main__":
    main()
