"""The gallery: a sentence and a picture of each of some packaged situations, driven, as a page of the documents.

    python benchmarks/gallery.py --out runs/gallery

runs each sentence with each ego of `EGOS` (ten scenes on one route, seed 0), takes the more dramatic of the first
scenes, and writes `docs/gallery.md` and the pictures in `docs/gallery/`: the moment of contact, or the one at which ego
and adversary are nearest. `docs/gallery/openscenario.zip` has the same scenes for other players, with the maps. Runs
that are there already are resumed.
"""

from __future__ import annotations

import argparse
import tempfile
import zipfile
from pathlib import Path

import chatscene
from chatscene.report.animation import still
from chatscene.runs import open_run, read_drawing

EGOS = ("planner", "idm")
PAGES = Path(__file__).parents[1] / "docs"
SITUATIONS = {
    "On foot": (
        "A pedestrian crosses the street from the right.",
        "A child dashes across the street from the left.",
        "A group of pedestrians crosses at the crosswalk in front of us.",
        "A pedestrian walks ahead of us along our lane in the same direction.",
        "We turn left at a junction, and a pedestrian crosses the street that we turn into.",
        "At night in the rain, a pedestrian crosses the street from the right.",
    ),
    "On two wheels": (
        "A cyclist ahead of us swerves.",
        "A cyclist rides out from behind a parked car on the right at 10 km/h.",
        "A motorcycle cuts us off from the left.",
        "We change lanes to the left while a motorcycle overtakes us on that side.",
        "We turn left at a junction while an oncoming motorcycle drives straight on.",
    ),
    "Ahead of us": (
        "The car ahead brakes hard.",
        "The car ahead of us reverses.",
        "The truck ahead stops suddenly.",
        "The car ahead of us swerves around a car that stands in our lane.",
    ),
    "Beside and behind us": (
        "A car cuts in from the right.",
        "A car overtakes us and cuts in.",
        "An ambulance comes up fast behind us in our lane.",
        "A car pulls out from the kerb.",
        "The car behind us drives too close.",
    ),
    "Oncoming": (
        "An oncoming car swerves into our lane.",
        "An oncoming car turns left across our path.",
        "A car comes toward us in our lane on the wrong side of the road.",
        "In a bend, an oncoming car comes over into our lane.",
        "We go around a parked car while an oncoming motorcycle approaches.",
    ),
    "At a junction": (
        "A car from the right runs the red light.",
        "An ambulance from the right runs the red light.",
        "A car from the left crosses the intersection in front of us.",
        "A car from the right runs the stop sign and crosses in front of us.",
        "At a T-junction, a car comes from the left while we turn left.",
        "We turn right at a junction while a car comes from the left.",
    ),
    "On a motorway": (
        "On a motorway, a car beside us on the right cuts in ahead of us.",
        "On a motorway, the car ahead of us leaves our lane, and behind it a car stands still.",
        "We merge onto a motorway from the on-ramp, and the car ahead of us brakes.",
    ),
    "Animals and things": (
        "A deer crosses the road from the right in front of us.",
        "A box lies on the road in our lane ahead.",
        "Two crashed cars stand in our lane ahead, and we change lanes to the left.",
    ),
}
HEAD = """# Gallery

**What can I say, and what does it look like?** Each sentence was run with two egos, `planner` and `idm`: ten scenes on
one route, at the usual speed for the road. Both see every road user nearby that nothing hides, and can use full
braking. Each picture shows the more dramatic of the two reports' first scenes, and the most dramatic pictures come
first. The ego is blue, adversaries are orange, occluders and blockers are brown, and a star marks the contact.
`python benchmarks/gallery.py --out runs/gallery` made this page (seed 0).

[All of these scenes as OpenSCENARIO](gallery/openscenario.zip), with the maps, for esmini or another
[player](exports.md#openscenario)."""
FIGURE = """<figure>
<img src="gallery/{picture}" alt="">
<figcaption>{sentence} <small>{what}</small></figcaption>
</figure>"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, help="the folder that the runs go to")
    out = parser.parse_args().out
    page = [HEAD]
    with zipfile.ZipFile(PAGES / "gallery" / "openscenario.zip", "w") as files:
        sections = []
        for heading, sentences in SITUATIONS.items():
            figures = sorted((figure(sentence, out, files) for sentence in sentences), reverse=True)
            shown = [f"## {heading}", '<div class="gallery">', *(picture for _, picture in figures), "</div>"]
            sections.append((figures[0][0], shown))
        for _, shown in sorted(sections, reverse=True):
            page += shown
    (PAGES / "gallery.md").write_text("\n\n".join(page) + "\n")


def figure(sentence: str, out: Path, files: zipfile.ZipFile) -> tuple[float, str]:
    """Run a sentence, draw its most dramatic first scene, and put that among the files.

    Returns:
        How dramatic it is (`drama`), and the picture with the sentence and what happened.
    """
    name = "-".join("".join(c for c in sentence.lower() if c.isalnum() or c == " ").split())
    runs = {ego: driven(sentence, out / ego / name, ego) for ego in EGOS}
    ego, run = max(runs.items(), key=lambda one: drama(one[1].best))
    picture = PAGES / "gallery" / f"{name}.webp"
    picture.parent.mkdir(exist_ok=True)
    picture.write_bytes(still(run.best.episode, read_drawing(open_run(run.folder))))
    pack(files, name, run.folder, run.best.id)
    row = run.best.row
    what = f"crashes at {3.6 * row['impact_speed']:.0f} km/h" if row["collision"] else "avoids the crash"
    print(f"{sentence}  {ego} {what}", flush=True)
    return drama(run.best), FIGURE.format(sentence=sentence, picture=picture.name, what=f"{ego} {what}")


def driven(sentence: str, folder: Path, ego: str) -> chatscene.Run:
    """The run of a sentence with an ego, finished if it was begun before."""
    run = chatscene.resume(folder) if (folder / "run.json").exists() else None
    if not isinstance(run, chatscene.Run):
        run = chatscene.run(sentence, folder, scenes=10, routes=1, seed=0, ego=ego)
    return run


def drama(scene: chatscene.DrivenScene) -> float:
    """The speed of the impact [m/s]; without a crash the negative gap [m] at the nearest moment."""
    row = scene.row
    return row["impact_speed"] if row["collision"] else -(row["distance"] if row["distance"] is not None else 1e3)


def pack(files: zipfile.ZipFile, name: str, run: Path, scene: str) -> None:
    """Put a scene, and its map if it is not there yet, into the files; the same scene gives the same bytes."""
    with tempfile.TemporaryDirectory() as folder:
        chatscene.export(run, scene, to="openscenario", out=folder)
        for path in sorted(Path(folder).iterdir()):
            told = zipfile.ZipInfo(path.name if path.suffix == ".xodr" else f"{name}{path.suffix}")
            told.compress_type = zipfile.ZIP_DEFLATED
            if told.filename not in files.namelist():
                files.writestr(told, path.read_bytes(), compresslevel=9)


if __name__ == "__main__":
    main()
