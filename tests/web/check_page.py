#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Uses the page of build/web in Chromium: what its links hold, what it keeps, and how it is touched.

    tests/web/check_page.py                     prints the promises that hold; the exit code says whether all do
    tests/web/check_page.py --pictures FOLDER     also saves what the page showed then

scripts/web.sh --test calls it. Each check waits for states of the page, never for seconds.
"""
import argparse
import functools
import http.server
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

import chromium

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
IS_STARTED = "document.getElementById('start').style.display === 'none'"
# Journals in the database of the page, and the settings there.
KEPT = """new Promise((resolve, reject) => {
  const request = indexedDB.open('mesecina', 1);
  request.onerror = () => reject(request.error);
  request.onsuccess = () => {
    const files = request.result.transaction('files').objectStore('files');
    const keys = files.getAllKeys(), values = files.getAll();
    values.onsuccess = () => {
      request.result.close();
      const texts = {};
      keys.result.forEach(([owner, path], i) => {
        texts[path] = (texts[path] || '') + new TextDecoder().decode(values.result[i]);
      });
      resolve(texts);
    };
  };
})"""


def edits(session):
    """The timeline without the views, which also depend on the panels."""
    return [entry for entry in session["timeline"] if "view" not in entry]


class Server:
    """A server of the files of the tree that knows nothing of the page."""

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def do_GET(self):
            if not self.path.startswith("/outer?"):
                return super().do_GET()
            self.send_response(200)
            self.send_header("Content-Type", "text/html")
            self.end_headers()
            self.wfile.write(f'<iframe src="{self.path[7:]}" width="900" height="500"></iframe>'.encode())

    def __init__(self):
        handler = functools.partial(self.Handler, directory=str(ROOT))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.link = f"http://127.0.0.1:{self.server.server_address[1]}/build/web/index.html"


class Checks:
    def __init__(self, pictures):
        self.pictures = pictures and pathlib.Path(pictures)
        if self.pictures:
            self.pictures.mkdir(parents=True, exist_ok=True)
        self.link = Server().link
        self.profile = None  # where the browser keeps what the page gives it
        self.browser = None

    def start(self, link):
        self.browser = chromium.Chromium(self.profile, link)
        self.wait_for_start(self.browser.page)
        return self.browser

    def wait_for_start(self, page):
        page.wait_for(IS_STARTED, "the program starts")
        page.wait_for("document.title.endsWith(' - Mesecina')", "the document has a title")
        page.evaluate("navigator.clipboard.writeText = async text => { window.copied = text; }")

    def run_command(self, page, name):
        page.press("k", control=True)
        page.type(name)
        page.press("Enter")

    def share(self, page):
        """The link that Share copies, and the session that it was made of."""
        page.evaluate("""delete window.copied; window.made ??= share;
                         window.share = (session, ...more) => {
                           window.shared = session;
                           return made(session, ...more);
                         }; 0""")
        self.run_command(page, "share")
        link = page.wait_for("window.copied", "Share copies a link")
        return link, json.loads(page.evaluate("shared"))

    def say(self, page, name, shown=None):
        if self.pictures:
            (shown or page).picture(self.pictures / (name.replace(" ", "_") + ".png"))
        if page.complaints:
            raise AssertionError("the console has errors: " + "; ".join(page.complaints))
        print("holds:", name, flush=True)

    def check_links(self):
        browser = self.start(self.link + "?open=../../assets/shapes/bean.poff")
        page = browser.page
        page.wait_for("document.title === 'bean.poff - Mesecina'", "the file of the link opens")
        self.say(page, "a link opens a file of the site")

        before = self.share(page)[1]
        page.press("i")
        for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
            page.mouse(kind, 300, 300, "none" if kind == "mouseMoved" else "left")
        page.wait_for("document.title.startsWith('* ')", "a click inserts a sample")
        link, session = self.share(page)
        assert len(edits(session)) > len(edits(before)), "the link holds no edit"
        self.say(page, "a link holds the session")

        page.evaluate("""window.tell = _mes_set_shared;
                         _mes_set_shared = (...answers) => { window.kind = answers[2]; tell(...answers); }; 0""")
        for _ in range(4):
            page.press("a", control=True)
            page.press("d", control=True)
        self.run_command(page, "share")
        assert page.wait_for("window.kind", "a long link is refused") == 2, "a long link is not too long"
        self.say(page, "a session that is too large for a link is not copied")

        second = browser.open(link)
        self.wait_for_start(second)
        second.wait_for("document.title === 'bean.json - Mesecina'", "the session of the link opens")
        again = self.share(second)[1]
        assert edits(again) == edits(session), "the link loses the timeline"
        for part in ("data", "layers", "settings"):
            assert again[part] == session[part], f"the link loses the {part}"
        self.say(second, "a link opens with everything in it")

        second.go_to("about:blank")
        second.go_to(link[:len(link) // 2])
        second.wait_for("document.getElementById('status').textContent.includes('is damaged')", "the damage is said")
        self.say(second, "half a link is refused in one line")

    def recover(self, page, promise):
        """Enter answers the question, as soon as it is there."""
        page.wait_for("document.title === '* bean.poff - Mesecina'", "the work is recovered",
                      lambda: page.press("Enter"))
        self.say(page, promise)

    def check_keeping(self):
        browser = self.start(self.link + "?open=../../assets/shapes/bean.poff")
        page = browser.page
        page.wait_for("document.title === 'bean.poff - Mesecina'", "the file of the link opens")
        page.press("d", shift=True)
        page.press("a", control=True)
        page.press("Delete")
        page.wait_for("document.title.startsWith('* ')", "the samples are deleted")
        kept = f"Object.entries(await {KEPT})"
        page.wait_for(f"""(async () => {kept}.some(([path, text]) => path.endsWith('.journal') &&
                          text.trim().split('\\n').length > 1))()""", "the journal has the edit")
        page.wait_for(f"""(async () => {kept}.some(([path, text]) => path.endsWith('settings.json') &&
                          JSON.parse(text).theme === 'dark'))()""", "the settings have the theme")
        self.say(page, "edits and settings are kept")

        second = browser.open(self.link)
        self.wait_for_start(second)
        self.share(second)
        self.say(second, "work of a living page is not offered")
        browser.kill()

        browser = self.start(self.link)
        self.recover(browser.page, "a browser that is killed loses no work")
        browser.page.press("z", control=True)
        assert "undo" in edits(self.share(browser.page)[1])[-1], "nothing is undone"
        browser.page.close()
        page = browser.open(self.link)
        self.wait_for_start(page)
        self.recover(page, "a page that is closed at once loses no work")
        assert "undo" in edits(self.share(page)[1])[-1], "the last step is lost"

    def view(self, page):
        """The part of the plane that the page shows at rest."""
        view = None
        while True:
            before, view = view, self.share(page)[1]["view"]
            if view == before:
                return view

    def check_touch(self):
        browser = self.start(self.link + "?open=../../assets/shapes/bean.poff")
        page = browser.page
        page.wait_for("document.title === 'bean.poff - Mesecina'", "the file of the link opens")
        page.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        before = self.view(page)

        def width(box):
            return box[2] - box[0]

        page.touch("touchStart", (400, 400))
        page.touch("touchStart", (400, 400), (500, 400))
        for step in range(1, 11):
            page.touch("touchMove", (400 - 5 * step, 400), (500 + 5 * step, 400))
        page.touch("touchEnd")
        after = self.view(page)
        assert abs(width(after) / width(before) - 0.5) < 0.01, f"the view {before} becomes {after}"
        self.say(page, "two fingers enlarge the drawing")

        page.touch("touchStart", (400, 400), (500, 400))
        for step in range(1, 11):
            page.touch("touchMove", (400 + 10 * step, 400), (500 + 10 * step, 400))
        page.touch("touchEnd")
        moved = self.view(page)
        is_moved = abs(width(moved) / width(after) - 1.0) < 0.001 and moved[0] < after[0]
        assert is_moved, "two fingers do not move the view"
        self.say(page, "two fingers move the drawing")

        page.press("s")
        page.touch("touchStart", (300, 300))
        for step in range(1, 11):
            page.touch("touchMove", (300 + 10 * step, 300))
        page.touch("touchStart", (400, 300), (500, 300))
        page.touch("touchMove", (400, 310), (500, 310))
        page.touch("touchEnd")
        self.share(page)
        assert page.evaluate("document.title") == "bean.poff - Mesecina", "the stroke of the first finger stays"
        self.say(page, "a second finger takes back what the first did")

        page.touch("touchStart", (300, 300))
        for step in range(1, 11):
            page.touch("touchMove", (300 + 10 * step, 300))
        page.touch("touchEnd")
        page.wait_for("document.title.startsWith('* ')", "the stroke becomes samples")
        self.say(page, "one finger is the tool")

    def check_lesson(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="lesson-", dir=ROOT / "build"))
        try:
            subprocess.run([ROOT / "build/release/mesecina", "lesson", "crust", "--web", folder, "--force"], check=True)
            page = self.start(self.link.replace("web/index.html", folder.name + "/")).page
            page.wait_for("document.title === 'lesson.json - Mesecina'", "the lesson opens")
            page.press("PageDown")  # from the title, which covers everything
            page.wait_for("!_mes_is_on_panel(innerWidth - 20, innerHeight / 2)", "a presentation hides the panels")
            self.say(page, "the folder of a lesson presents it")
            page.press("Escape")
            page.wait_for("_mes_is_on_panel(innerWidth - 20, innerHeight / 2)", "the panels come back")
            self.say(page, "the lesson ends in its document")
        finally:
            shutil.rmtree(folder)

    def check_frame(self):
        self.browser = chromium.Chromium(
            self.profile, self.link.replace("/build/web/index.html", "/outer?") +
            self.link.replace("127.0.0.1", "localhost") + "?open=../../assets/shapes/bean.poff")
        page = self.browser.page_at(self.link.replace("127.0.0.1", "localhost"), "iframe")
        page.wait_for("document.title === 'bean.poff - Mesecina'", "the file of the link opens")
        self.say(page, "the page runs within a page of another site", self.browser.page)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pictures", metavar="FOLDER")
    checks = Checks(parser.parse_args().pictures)
    for check in (checks.check_links, checks.check_keeping, checks.check_touch, checks.check_lesson,
                  checks.check_frame):
        checks.profile = tempfile.mkdtemp(prefix="mesecina-page-")
        try:
            check()
        except AssertionError as error:
            print("FAILS:", error, file=sys.stderr)
            return 1
        finally:
            if checks.browser:
                checks.browser.kill()
            shutil.rmtree(checks.profile, ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
