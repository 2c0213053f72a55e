# SPDX-License-Identifier: GPL-3.0-or-later
"""The native window on a session, with real keys and a real mouse."""
import asyncio
import os
import shutil
import signal
import subprocess
import time

import numpy as np
import pytest

import mesecina as mes
from conftest import flower_points

pytestmark = pytest.mark.skipif(not (shutil.which("Xvfb") and shutil.which("xdotool")), reason="no Xvfb or xdotool")


@pytest.fixture
def display(tmp_path, monkeypatch):
    """A screen of its own, and a home without settings."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
                               "-noreset"], pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as number:
        monkeypatch.setenv("DISPLAY", f":{number.readline().strip()}")
    for name, folder in (("HOME", "home"), ("XDG_CONFIG_HOME", "config"), ("XDG_DATA_HOME", "data"), ("XDG_CACHE_HOME", "cache")):
        (tmp_path / folder).mkdir()
        monkeypatch.setenv(name, str(tmp_path / folder))
    yield
    server.terminate()
    server.wait()


def until(window, holds):
    """Follows the window until something holds, which is soon, but for a busy machine."""
    end = time.monotonic() + 600
    while not holds():
        assert window.wait(0.05), "the window has closed"
        assert time.monotonic() < end


def press(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True)


def until_seen(window, size):
    """The window has drawn a picture, and follows keys and mouse."""
    until(window, lambda: subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "Mesecina"],
                                         capture_output=True, check=False).stdout != b"")
    count = size()

    def inserted():
        press("mousemove", 430, 300, "key", "i", "click", 1)
        window.wait(0.3)
        return size() > count

    until(window, inserted)


def test_edits_go_both_ways(display):
    session = mes.Session(flower_points(40), balls=[[5, 5, 1]])
    ids = session.ids
    said = []
    assert session.on_change(said.append)
    window = mes.window(session)
    assert window.is_open and "open" in repr(window)
    until_seen(window, lambda: len(session))
    assert said[0] is session
    # What the user did is a step here, with new ids, and old ones as they were.
    np.testing.assert_array_equal(session.ids[:40], ids)
    inserted = len(session) - 40
    for _ in range(inserted):
        assert session.undo()
    assert len(session) == 40
    # What is done here can be undone there.
    with session.edit("Two"):
        session.remove(ids[:10])
        session.insert([[3.0, 0.0]])
    until(window, lambda: window._made == window._number)
    press("key", "ctrl+z")
    until(window, lambda: len(session) == 40)
    np.testing.assert_array_equal(np.sort(session.points, axis=0), np.sort(flower_points(40), axis=0))
    press("key", "ctrl+a", "key", "Delete")
    until(window, lambda: len(session) == 0 and len(session.balls) == 0)
    window.close()
    # It ended by itself, and left no work to be offered at the next start.
    assert window._process.returncode == 0
    assert not window.is_open and window.poll() is False and not session.insert((1, 1)) is None
    window.close()


def find(words):
    """Finds a command in the window by its name."""
    press("key", "ctrl+k")
    press("type", "--delay", "20", words)
    press("key", "Return")


def test_contours_and_settings_go_both_ways(display):
    session = mes.Session(flower_points(40), contours=[range(40)])
    window = mes.window(session)
    until_seen(window, lambda: len(session))
    ring = session.ids[:10]
    session.contours = [(range(10), False)]
    session.set("pole-propagation", 1 - session.value("pole-propagation"))
    session.set("lambda-limit", 0.75)
    until(window, lambda: window._made == window._number)
    # What was open here is closed there, and turned around.
    press("key", "ctrl+a")
    find("close contours")
    until(window, lambda: session.contours[0][1])
    find("reverse contours")
    until(window, lambda: session.ids[session.contours[0][0]].tolist() != ring.tolist())
    assert set(session.ids[session.contours[0][0]].tolist()) == set(ring.tolist())
    # A switch that was turned here is turned back there, and a number type chosen there is chosen here.
    before = mes.Session().value("pole-propagation")
    find("pole labels by propagation")
    until(window, lambda: session.value("pole-propagation") == before)
    find("exact with roots")
    until(window, lambda: session.value("precision") == "exact-roots")
    assert session.value("lambda-limit") == 0.75
    window.close()


def test_the_window_ends_without_the_session(display):
    session = mes.Session(flower_points(20))
    window = mes.window(session)
    until_seen(window, lambda: len(session))
    window._process.send_signal(signal.SIGKILL)
    assert window.wait() is False
    session.insert((0.5, 0.5))
    assert session.axis


def test_an_event_loop_follows_by_itself(display):
    session = mes.Session(flower_points(20))
    changed = []
    session.on_change(lambda one: changed.append(len(one)))

    async def work():
        window = mes.window(session)
        while not changed:
            press("mousemove", 430, 300, "key", "i", "click", 1)
            await asyncio.sleep(0.2)
        window.close()

    asyncio.run(asyncio.wait_for(work(), 600))
    assert changed[0] > 20


def test_a_callback_that_raises_is_the_callers(display):
    session = mes.Session(flower_points(20))

    @session.on_change
    def fail(one):
        raise LookupError("callback")

    window = mes.window(session)
    with pytest.raises(LookupError):
        until_seen(window, lambda: 0)
    assert len(session) > 20 and window.is_open
    window.close()


def test_a_program_that_is_not_there(monkeypatch):
    monkeypatch.setenv("MESECINA_PROGRAM", "/nowhere/mesecina")
    with pytest.raises(FileNotFoundError):
        mes.window(mes.Session())


def test_without_a_display(monkeypatch):
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    session = mes.Session(flower_points(20))
    window = mes.window(session)
    with pytest.raises(mes.ProgramError, match="display"):
        window.wait()
    assert not window.is_open and len(session) == 20
