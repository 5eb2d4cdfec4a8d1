"""Opens the page of `lumaknot validate` in headless Chromium and uses it as a person would.

    report_test.py LUMAKNOT [SCREENSHOTS]

LUMAKNOT is the program; SCREENSHOTS a folder for pictures of the page, for people. Exit status 0: the page does
what it should; 1: what it does not is printed; 3: Chromium is not installed.
"""

import json
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

sys.dont_write_bytecode = True
from chromium import Browser, find_browser  # noqa: E402  (it is next to this script)

WIDTH, HEIGHT = 1280, 800
MAX_BYTES = 4_000_000
# A cube without normals, which POV-Ray turns to the viewer: a large part of its pixels differ.
CUBE = """v -1 -1 -1
v 1 -1 -1
v 1 1 -1
v -1 1 -1
v -1 -1 1
v 1 -1 1
v 1 1 1
v -1 1 1
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
"""
# A name that would run if the page trusted it.
EVIL = "<script>document.title='owned'<!--&amp;\".json"


class Failures(list):
    """Lines of what is wrong."""

    def check(self, holds, what):
        if not holds:
            self.append(what)


def validate(program, folder, scene, *flags):
    """Runs the command; its exit status is not judged here, as the renderers may differ."""
    done = subprocess.run([program, "validate", scene, *flags, "-o", folder / "report"], cwd=folder, text=True,
                          capture_output=True)
    if done.returncode not in (0, 1):
        sys.exit(f"lumaknot validate: {done.stdout}{done.stderr}")
    return folder / "report/report.html", json.loads((folder / "report/report.json").read_text(encoding="utf-8"))


def make_cube(folder):
    (folder / "cube.obj").write_text(CUBE, encoding="ascii")
    scene = {"mesh": {"file": "cube.obj"}, "texture": {"color": [0.6, 0.5, 0.4]},
             "camera": {"position": [3, -4, 2.4], "fov_degrees": 45}, "image": {"width": 120, "height": 90}}
    (folder / EVIL).write_text(json.dumps(scene), encoding="ascii")
    return EVIL


def png16(path):
    """width and rows of r, g, b, a in [0, 1] of a PNG file of 16 bits that isn't interlaced."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width, height, bits, color = struct.unpack(">IIBB", data[at + 8:at + 18])
            assert (bits, color) == (16, 6), "16 bits of red, green, blue and alpha"
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    raw, stride, rows = zlib.decompress(packed), 8 * width, []
    above = bytearray(stride)
    for y in range(height):
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        unfilter(raw[y * (stride + 1)], line, above)
        rows.append([v / 65535 for v in struct.unpack(f">{4 * width}H", line)])
        above = line
    return width, rows


def unfilter(kind, line, above):
    """Undoes a row's filter (PNG, section 9)."""
    for i in range(len(line)):
        a, b, c = (line[i - 8], above[i], above[i - 8]) if i >= 8 else (0, above[i], 0)
        nearest = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        line[i] = (line[i] + (0, a, b, (a + b) // 2, nearest)[kind]) & 255


def pixels_of(browser, canvas="#picture"):
    """A hash of a canvas' pixels, and how bright they are together."""
    return browser.evaluate(
        f"(() => {{ const c = document.querySelector('{canvas}');"
        " const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; let h = 0, s = 0;"
        " for (let i = 0; i < d.length; ++i) { h = Math.imul(h ^ d[i], 16777619); if (i % 4 < 3) s += d[i]; }"
        " return [h, s]; })()")


def choose(browser, renderer, shot):
    browser.click(f'button[data-renderer="{renderer}"][data-shot="{shot}"]')
    browser.wait_for(f"view.row === {renderer} && view.column === {shot + 1} && view.pixels && "
                     f"document.querySelector('#readout tr[aria-current]')?.dataset.shot === '{shot}'")


def readout(browser):
    """The current stage's ours, theirs and error, with the error's tolerance."""
    cells = browser.evaluate("[...document.querySelector('#readout tr[aria-current]').cells].map(c => c.textContent)")
    ours, theirs = ([float(v) for v in cells[i].split()] for i in (1, 2))
    numbers = [float(v) for v in re.findall(r"[-+.e\d]+", cells[3])]
    error, tolerance = numbers if "±" in cells[3] else (0, numbers[0])
    return ours, theirs, error, tolerance


def check_layout(browser, page, failures):
    failures.check(page.stat().st_size <= MAX_BYTES, f"the page has {page.stat().st_size} bytes")
    for selector in (".matrix img", "button.cell", "#picture"):
        left, top, right, bottom = browser.box(selector)
        failures.check(left >= 0 and top >= 0 and right <= WIDTH and bottom <= HEIGHT and right > left,
                       f"{selector} is at {left}, {top}, {right}, {bottom}: not in view")
    fetched = browser.evaluate("performance.getEntriesByType('resource').map(entry => entry.name.slice(0, 80))")
    outside = [url for url in fetched if not url.startswith("data:")]
    failures.check(not outside, f"the page asks for {outside}")


def check_modes(browser, failures):
    browser.press("t")
    theirs = pixels_of(browser)
    browser.press("o")
    ours = pixels_of(browser)
    failures.check(ours != theirs, "ours and theirs look alike where they differ")
    browser.click('[data-mode="difference"]')
    browser.evaluate("gainInput.value = 0; gainInput.dispatchEvent(new Event('input'))")
    dark = pixels_of(browser)
    browser.evaluate("gainInput.value = 4; gainInput.dispatchEvent(new Event('input'))")
    failures.check(pixels_of(browser)[1] > dark[1], "the gain does not brighten the difference")
    browser.press("-")
    failures.check(browser.evaluate("document.getElementById('gain-text').textContent") == "× 8",
                   "the key - does not lower the gain")
    browser.press("w")
    for place, picture in ((0, ours), (1000, theirs)):
        browser.evaluate(f"wipeInput.value = {place}; wipeInput.dispatchEvent(new Event('input'))")
        # The wipe's own line covers a column at most.
        failures.check(abs(pixels_of(browser)[1] - picture[1]) <= 90 * 3 * 255, f"the wipe at {place / 10} %")
    browser.press("f")
    browser.wait_for("document.getElementById('badge').textContent === 'ours'")
    failures.check(pixels_of(browser) == ours, "flicker does not show ours")
    browser.wait_for("document.getElementById('badge').textContent === 'theirs'")
    failures.check(pixels_of(browser) == theirs, "flicker does not show theirs")
    for mode, key in (("classes", "c"), ("flip", "p")):
        browser.press(key)
        failures.check(browser.evaluate(f"view.mode === '{mode}'"), f"{key} does not show {mode}")
        failures.check(pixels_of(browser) not in (ours, theirs), f"{mode} looks like another mode")
    failures.check("turned normal" in browser.evaluate("document.getElementById('legend').textContent"),
                   "the legend does not name the class")
    failures.check(browser.evaluate("document.querySelectorAll('#histogram rect').length") > 10, "no histogram")


def check_coverage(browser, failures):
    browser.click('button[data-renderer="0"][data-shot="coverage"]')
    browser.wait_for("view.column === 0 && document.getElementById('title').textContent.includes('coverage')")
    legend = browser.evaluate("document.getElementById('legend').textContent")
    failures.check("covered by" in legend and "turned normal" not in legend, f"coverage shows: {legend}")


def check_keyboard(browser, failures):
    choose(browser, 0, 1)
    browser.press("ArrowRight")
    browser.wait_for("view.column === 3 && document.activeElement.dataset.shot === '2'")
    browser.press("ArrowDown")
    browser.wait_for("view.row === 1")
    browser.press("m")
    largest = "Math.max(...Array.from({length: 120 * 90}, (_, pixel) => view.pixels.error(pixel)))"
    failures.check(browser.evaluate(f"view.pixels.error(view.y * 120 + view.x) === {largest}"),
                   "m does not go to the largest error")
    x = browser.evaluate("view.x")
    browser.press("ArrowRight", shift=True)
    failures.check(browser.evaluate("view.x") == x + 1, "Shift and an arrow do not move the pixel")
    browser.press("?")
    failures.check(browser.evaluate("document.getElementById('help').open"), "? does not open the list of keys")
    browser.press("o")
    browser.click("#help button")
    failures.check(not browser.evaluate("document.getElementById('help').open"), "the list of keys stays open")


def check_pointer(browser, failures):
    browser.press("t")
    left, top, right, bottom = browser.box("#picture")
    browser.mouse("mouseMoved", left + (right - left) * 0.25 + 0.5, top + (bottom - top) * 0.5 + 0.5)
    chosen = browser.evaluate("[view.x, view.y, picture.width, picture.height]")
    failures.check(abs(chosen[0] - chosen[2] / 4) <= 1 and abs(chosen[1] - chosen[3] / 2) <= 1,
                   f"the pointer chooses {chosen}")


def check_values(browser, json_report, ours_file, failures):
    """The readout against the report's own numbers, and against our picture drawn by another command."""
    _, rows = png16(ours_file)
    for r, renderer in enumerate(json_report["renderers"]):
        for s, shot in enumerate(renderer["shots"]):
            choose(browser, r, s)
            where = f"{renderer['renderer']}, {shot['shot']}"
            x, y = shot["comparison"]["max_at"]
            browser.evaluate(f"choosePixel({x}, {y})")
            ours, theirs, error, tolerance = readout(browser)
            true = shot["comparison"]["max"]
            failures.check(abs(error - true) <= tolerance + 5e-3 * true,  # three digits are shown
                           f"{where}: error {error} +- {tolerance}, in truth {true}")
            largest = max(abs(a - b) for a, b in zip(ours, theirs))
            failures.check(abs(largest - error) <= 1.5e-3 + 5e-3 * error,  # three decimals each
                           f"{where}: {ours} and {theirs} are not {error} apart")
            if shot["shot"] == "scene":
                truth = rows[y][4 * x:4 * x + 3]
                failures.check(all(abs(min(a, 1) - b) <= 0.0025 for a, b in zip(ours, truth)),  # 1/510, three decimals
                               f"{where}: ours is {ours}, in truth {truth}")


def check_schemes(browser, failures, pictures):
    colors = "[getComputedStyle(document.body).color, getComputedStyle(document.querySelector('.agreed')).color]"
    found = {}
    for scheme in ("light", "dark"):
        browser.prefer(scheme)
        found[scheme] = browser.evaluate(colors)
        if pictures:
            browser.screenshot(pictures / f"{scheme}.png")
    failures.check(all(a != b for a, b in zip(found["light"], found["dark"])), f"light and dark alike: {found}")
    browser.prefer("light")
    if pictures:
        browser.print_pdf(pictures / "print.pdf")


def check_figure2(program, chromium, folder, failures, pictures):
    page, _ = validate(program, folder, "figure2", "--renderer", "povray,gl")
    with Browser(chromium, WIDTH, HEIGHT) as browser:
        browser.open(page)
        browser.wait_for("document.body.dataset.ready")
        check_layout(browser, page, failures)
        check_schemes(browser, failures, pictures)
        failures.extend(browser.errors)


def check_cube(program, chromium, folder, failures):
    scene = make_cube(folder)
    page, json_report = validate(program, folder, scene, "--renderer", "povray,gl", "--model", "scene")
    subprocess.run([program, "render", scene, "-o", folder / "ours.png", "--quiet"], cwd=folder, check=True)
    with Browser(chromium, WIDTH, HEIGHT) as browser:
        browser.open(page)
        browser.wait_for("document.body.dataset.ready")
        failures.check(browser.evaluate("document.title").startswith("lumaknot: <script>"), "the name is not shown")
        check_values(browser, json_report, folder / "ours.png", failures)
        choose(browser, 0, 3)
        check_modes(browser, failures)
        check_coverage(browser, failures)
        check_keyboard(browser, failures)
        check_pointer(browser, failures)
        failures.extend(browser.errors)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    chromium = find_browser()
    if not chromium:
        print("chromium not found; install it with scripts/install browser")
        return 3
    program, failures = Path(sys.argv[1]).resolve(), Failures()
    pictures = Path(sys.argv[2]) if len(sys.argv) == 3 else None
    for check in (lambda folder: check_figure2(program, chromium, folder, failures, pictures),
                  lambda folder: check_cube(program, chromium, folder, failures)):
        with tempfile.TemporaryDirectory() as folder:
            check(Path(folder))
    print("\n".join(failures), end="\n" if failures else "")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
