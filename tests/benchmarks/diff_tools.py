"""What `ropesim diff` and common tools see at their defaults of four faults in a frame, and how long they take
for a folder of frames. Needs npm (pixelmatch, pngjs) and ImageMagick (compare).

usage: diff_tools.py ROPESIM [PAIRS]
"""

import csv
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time

PIXELMATCH = """
const fs = require('fs'), { PNG } = require('pngjs');
(async () => {
  const pixelmatch = (await import('pixelmatch')).default;
  const [a, b] = process.argv.slice(2);
  const names = fs.statSync(a).isDirectory() ? fs.readdirSync(a).filter(n => n.endsWith('.png')) : [''];
  let changed = 0;
  for (const name of names) {
    const read = side => PNG.sync.read(fs.readFileSync(side + (name && '/' + name)));
    const x = read(a), y = read(b);
    changed += pixelmatch(x.data, y.data, null, x.width, x.height);
  }
  console.log(changed);
})();
"""

FRAME = 60


def run(*arguments, folder, status=(0,)):
    done = subprocess.run([str(a) for a in arguments], cwd=folder, capture_output=True, text=True)
    assert done.returncode in status, done.stderr
    return done.stdout + done.stderr


def make_frames(ropesim, folder):
    """One rope of the seed's scene: a frame of it, and the same with four faults."""
    scene = run(ropesim, "scenes", "seed", folder=folder)
    one_rope = scene[:scene.rindex("[[rope]]")]
    half = one_rope.replace("nodes = 16", "nodes = 8")
    rope = half[half.index("[[rope]]"):].replace('"Euler"', '"rest"').replace("start = [0.0", "start = [-213.0")
    (folder / "right.toml").write_text(one_rope)
    (folder / "color.toml").write_text(one_rope.replace("#0000ff", "#0080ff"))
    (folder / "halves.toml").write_text(half.replace("pinned = [0]", "pinned = []") + rope.replace("pinned = [0]", ""))
    run(ropesim, "simulate", "right.toml", "--frames", FRAME, "-o", "right.csv", "--no-error", folder=folder)
    rows = list(csv.reader((folder / "right.csv").open()))

    def write(name, lines):
        with (folder / name).open("w") as file:
            csv.writer(file, lineterminator="\n").writerows([rows[0], *lines])

    halves = [[f, rope if int(n) < 8 else "rest", int(n) % 8, x, y] for f, rope, n, x, y in rows[1:]]
    moved = [[f, rope, n, x, float(y) + (1.0 if n == "9" else 0.0)] for f, rope, n, x, y in rows[1:]]
    write("halves.csv", halves)
    write("moved.csv", moved)

    def draw(name, scene, *more, frame=FRAME):
        run(ropesim, "render", scene, "--frames", frame, "-o", "drawn", "--overwrite", *more, folder=folder)
        shutil.move(folder / f"drawn/frame_{frame:04}.png", folder / name)
        shutil.rmtree(folder / "drawn")

    words = ["right.toml", "color.toml", "halves.toml"]
    for name in words:  # the words in the corner would differ, too
        path = folder / name
        path.write_text(path.read_text().replace("[clip]", "[clip]\nwords = false"))
    draw("right.png", "right.toml")
    draw("missing link.png", "halves.toml", "--positions", "halves.csv")
    draw("wrong colour.png", "color.toml")
    draw("mass moved by 1 px.png", "right.toml", "--positions", "moved.csv")
    draw("a frame late.png", "right.toml", frame=FRAME - 1)


def pixels_by_imagemagick(folder, name, *more):
    text = run("compare", "-metric", "AE", *more, "right.png", name, "null:", folder=folder, status=(0, 1))
    return int(float(re.findall(r"[0-9.e+]+", text)[0]))


def show_faults(ropesim, folder):
    """At the tools' defaults, with the fuzz that many jobs give ImageMagick, and by a budget that many give both."""
    picture = 960 * 640
    print("| fault | `ropesim diff` | pixelmatch | ImageMagick | `-fuzz 5%` | 1 % of the picture |")
    print("|---|---|---|---|---|---|")
    for name in ["missing link", "wrong colour", "mass moved by 1 px", "a frame late"]:
        file = name + ".png"
        ours = run(ropesim, "diff", "right.png", file, folder=folder, status=(0, 3)).splitlines()[-1]
        found = re.search(r"differs?: (\d+ of \d+)", ours)
        counts = [int(run("node", "pixelmatch.js", "right.png", file, folder=folder)),
                  pixels_by_imagemagick(folder, file), pixels_by_imagemagick(folder, file, "-fuzz", "5%")]
        share = 100 * max(counts) / picture
        cells = [f"differs, {found.group(1)}" if found else ours,
                 *(str(count) if count else "passes" for count in counts),
                 f"{'passes' if share < 1 else 'differs'}, {share:.2f} %"]
        print(f"| {name} | {' | '.join(cells)} |")


def seconds(task):
    """Of the processor, which other work on the machine does not stretch, and of the clock."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    used_before, start = used(), time.monotonic()
    task()
    return used() - used_before, time.monotonic() - start


def show_speed(ropesim, folder, pairs):
    scene = (folder / "right.toml").read_text().replace("frames = 120", f"frames = {pairs}")
    (folder / "long.toml").write_text(scene)
    run(ropesim, "render", "long.toml", "--size", "1280x720", "-o", "a", "--quiet", folder=folder)
    run(ropesim, "render", "long.toml", "--size", "1280x720", "-s", 63, "-o", "other", "--quiet", folder=folder)
    shutil.copytree(folder / "a", folder / "same")

    def magick(other):
        for name in sorted(path.name for path in (folder / "a").glob("*.png")):
            run("compare", "-metric", "AE", f"a/{name}", f"{other}/{name}", "null:", folder=folder, status=(0, 1))

    print(f"\n| {pairs} pairs of 1280 x 720: processor s (clock s) | equal | differing |\n|---|---|---|")
    for tool, task in {
        "`ropesim diff`": lambda other: run(ropesim, "diff", "a", other, folder=folder, status=(0, 3)),
        "pixelmatch": lambda other: run("node", "pixelmatch.js", "a", other, folder=folder),
        "ImageMagick `compare`": magick,
    }.items():
        cells = ["{:.1f} ({:.1f})".format(*seconds(lambda: task(other))) for other in ("same", "other")]
        print(f"| {tool} | {' | '.join(cells)} |", flush=True)


def main():
    ropesim = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run("npm", "install", "--silent", "--no-audit", "--no-fund", "pixelmatch", "pngjs", folder=folder)
        (folder / "pixelmatch.js").write_text(PIXELMATCH)
        make_frames(ropesim, folder)
        show_faults(ropesim, folder)
        show_speed(ropesim, folder, int(sys.argv[2]) if len(sys.argv) > 2 else 1000)


if __name__ == "__main__":
    main()
