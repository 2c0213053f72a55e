# SPDX-License-Identifier: GPL-3.0-or-later
"""The native window on a session: a process of its own, in which edits are those of the session, and the other way."""
import asyncio
import contextlib
import io
import json
import os
import select
import socket
import subprocess
import sys
import tempfile
import time
import weakref

import numpy as np

from . import _program
from ._experiments import Experiment


class Window:
    """A native window on a session (`window`).

    It is a process of its own: it closes, or crashes, without the interpreter, and stays open with its document when the
    interpreter ends. What the user does there becomes a step of undo of the session, and what the session does is drawn there.

    Everything of the session happens on the thread that uses it. In a notebook, and wherever an event loop of asyncio
    runs, the session follows by itself; a script calls `poll` or `wait`.
    """

    def __init__(self, session, experiments=()):
        self._session = weakref.ref(session)
        self._number = 0
        self._is_following = False  # a change of the window is being made here
        self._made = 0  # number of the last change of ours that the window has made
        self._revision = session._bench.revision
        self._lists = _lists_of(session)
        self._contours = _contours_of(session)
        self._settings = _settings_of(session)
        self._received = b""
        self._loop = None
        self._complaints = tempfile.TemporaryFile()  # a pipe that nobody reads would fill
        ours, theirs = socket.socketpair()
        words = [_program.path(), "--link", str(theirs.fileno())]
        self._carried = tempfile.TemporaryDirectory(prefix="mesecina-")
        for file in _files_of([*session.experiments, *experiments], self._carried.name):
            words += ["--with", file]
        try:
            self._process = subprocess.Popen(words, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL,
                                             stdout=subprocess.DEVNULL, stderr=self._complaints)
        except BaseException:
            ours.close()
            raise
        finally:
            theirs.close()
        self._socket = ours
        self._send({"session": session._bench.text("session").decode()})
        try:
            self._loop = asyncio.get_running_loop()
        except RuntimeError:
            return
        self._loop.add_reader(self._socket, self.poll)

    @property
    def is_open(self):
        """The window is there."""
        return self._socket is not None

    def poll(self):
        """Makes what was done in the window, and shows there what was done here. Does not wait. Returns `is_open`."""
        if self._socket is None or self._is_following:
            return self.is_open
        self._show()
        while self._socket is not None and select.select([self._socket], [], [], 0)[0]:
            self._receive()
        return self.is_open

    def wait(self, timeout=None):
        """Follows the window until it is closed, or for a time in seconds. Returns `is_open`."""
        end = None if timeout is None else time.monotonic() + timeout
        while self.poll():
            left = None if end is None else end - time.monotonic()
            if left is not None and left <= 0:
                break
            select.select([self._socket], [], [], left)
        return self.is_open

    def close(self):
        """Closes the window. The session stays as it is."""
        if self._socket is None:
            return
        self.poll()
        if self._socket is None:
            return
        self._send({"close": True})
        self._end()
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:  # it asks the user, or is held up
            self._process.terminate()
            self._process.wait()

    def _end(self):
        if self._socket is None:
            return
        if self._loop is not None:
            self._loop.remove_reader(self._socket)
        self._socket.close()
        self._socket = None
        self._carried.cleanup()

    def _say_why(self):
        """Raises what the program says if it did not begin, or did not end well; a signal is the user's."""
        status = self._process.wait()
        self._complaints.seek(0)
        said = self._complaints.read().decode(errors="replace").strip().removeprefix("mesecina: ")
        if status > 0 and said:
            raise _program.ProgramError(said.splitlines()[-1], status)

    def _send(self, message):
        try:
            self._socket.sendall(json.dumps(message).encode() + b"\n")
        except OSError:
            pass  # the window is gone, which the next reading sees

    def _receive(self):
        try:
            received = self._socket.recv(1 << 20)
        except OSError:
            received = b""
        if not received:
            self._end()
            self._say_why()
            return
        *lines, self._received = (self._received + received).split(b"\n")
        for line in lines:
            self._take(json.loads(line))

    def _show(self):
        """Sends what is different here from what both agreed on."""
        session = self._session()
        if session is None or session._bench.revision == self._revision:
            return
        message = {}
        for agreed, now, suffix in zip(self._lists, _lists_of(session), ("", "_balls")):
            message.update(agreed.difference(now, suffix))
        contours = _contours_of(session)
        if contours != _without(self._contours, session.ids):
            places = {one: place for place, one in enumerate(self._lists[0].ids.tolist())}
            message["contours"] = [[is_closed, [places[one] for one in ids]] for is_closed, ids in contours]
        self._contours = contours
        settings = _settings_of(session)
        changed = {name: value for name, value in settings.items() if self._settings.get(name) != value}
        if changed:
            message["settings"] = changed
        self._settings.update(settings)
        self._revision = session._bench.revision
        if message:
            self._number += 1
            self._send({"number": self._number, "name": "Python", **message})

    def _take(self, proposal):
        if "made" in proposal:
            self._made = proposal["made"]
            return
        session = self._session()
        if session is None:
            self._end()
            return
        self._show()
        if proposal["number"] != self._number + 1:
            return  # it crossed a change of ours, and comes again
        self._is_following = True
        try:
            self._follow(session, proposal)
        finally:
            self._is_following = False
        self._number += 1
        self._revision = session._bench.revision
        self._send({"accepted": self._number})
        for callback in list(session._listeners):
            callback(session)

    def _follow(self, session, proposal):
        samples, balls = self._lists
        with session.edit(proposal.get("name", "Window")):
            for one, suffix, move, remove, insert in ((samples, "", session.move, session.remove, session.insert),
                                                      (balls, "_balls", session.change_balls, session.remove_balls,
                                                       session.insert_balls)):
                one.follow(proposal, suffix, move, remove, insert)
            if "contours" in proposal:
                ids = self._lists[0].ids
                contours = [(ids[places], is_closed) for is_closed, places in proposal["contours"]]
                order = {one: place for place, one in enumerate(session.ids.tolist())}
                session.contours = [([order[one] for one in contour.tolist()], is_closed) for contour, is_closed in contours]
            self._contours = _contours_of(session)
            for name, value in proposal.get("settings", {}).items():
                self._settings[name] = value
                with contextlib.suppress(ValueError):  # a parameter that the window alone has
                    session.set(name, value)

    def __repr__(self):
        return f"<Window: {'open' if self.is_open else 'closed'}>"


class _List:
    """Samples or balls as both sides know them: ids of the session, and numbers, in an order that both have."""

    def __init__(self, ids, values):
        self.ids = np.asarray(ids)
        self.values = np.asarray(values)

    def difference(self, now, suffix):
        """What leads from here to the present; takes it as agreed."""
        order = np.argsort(now.ids, kind="stable")
        at = np.searchsorted(now.ids, self.ids, sorter=order)
        at = order[np.minimum(at, max(0, len(order) - 1))] if len(order) else np.zeros(len(self.ids), dtype=int)
        is_left = now.ids[at] == self.ids if len(now.ids) else np.zeros(len(self.ids), dtype=bool)
        is_new = ~np.isin(now.ids, self.ids)
        has_moved = np.zeros(len(self.ids), dtype=bool)
        has_moved[is_left] = (now.values[at[is_left]] != self.values[is_left]).any(axis=1)
        out = {}
        if has_moved.any():
            places = np.flatnonzero(has_moved)
            out["moved" + suffix] = [[int(i), *row] for i, row in zip(places, now.values[at[places]].tolist())]
        if not is_left.all():
            out["removed" + suffix] = np.flatnonzero(~is_left).tolist()
        if is_new.any():
            out["inserted" + suffix] = now.values[is_new].tolist()
        self.values = np.concatenate([now.values[at[is_left]], now.values[is_new]])
        self.ids = np.concatenate([self.ids[is_left], now.ids[is_new]])
        return out

    def follow(self, message, suffix, move, remove, insert):
        """Makes what a message says with the functions of a session."""
        moved = message.get("moved" + suffix, [])
        removed = np.array(message.get("removed" + suffix, []), dtype=int)
        inserted = message.get("inserted" + suffix, [])
        if moved:
            places = np.array([one[0] for one in moved])
            self.values = self.values.copy()
            self.values[places] = [one[1:] for one in moved]
            move(self.ids[places], self.values[places])
        if len(removed):
            remove(self.ids[removed])
            self.ids, self.values = np.delete(self.ids, removed), np.delete(self.values, removed, axis=0)
        if inserted:
            new = insert(inserted)
            self.ids, self.values = np.concatenate([self.ids, new]), np.concatenate([self.values, inserted])


def _lists_of(session):
    return _List(session.ids, session.points), _List(session.ball_ids, session.balls)


def _contours_of(session):
    """Contours by ids of samples: pairs of whether one is closed, and a list."""
    ids = session.ids
    return [(is_closed, ids[indices].tolist()) for indices, is_closed in session.contours]


def _without(contours, ids):
    """Contours without samples that are gone, and without those of which nothing is left."""
    alive = set(ids.tolist()) if contours else ()
    left = [(is_closed, [one for one in ids if one in alive]) for is_closed, ids in contours]
    return [one for one in left if one[1]]


def _settings_of(session):
    """The number type and the parameters by their ids."""
    return {name: session.value(name) for name in ("precision", *(one["id"] for one in session.catalogue.parameters()))}


def _files_of(experiments, folder):
    """Files that have the experiments, for ``--with``: those given, and one in the folder for those that are objects."""
    files = [os.fspath(one) for one in experiments if not isinstance(one, Experiment)]
    known = {os.path.realpath(file) for file in files}
    objects = [one for one in dict.fromkeys(experiments) if isinstance(one, Experiment)
               and os.path.realpath(one.__wrapped__.__code__.co_filename) not in known]
    if not objects:
        return files
    try:
        import cloudpickle
    except ImportError as error:
        raise ImportError("structures and layers of the session reach its window by cloudpickle, which is not installed; "
                          "a file of them may be named instead: window(session, experiments=[\"idea.py\"])") from error

    class Pickler(cloudpickle.CloudPickler):
        def reducer_override(self, one):
            return one._by_value() if isinstance(one, Experiment) else super().reducer_override(one)

    pickled = io.BytesIO()
    Pickler(pickled).dump(objects)
    carried = os.path.join(folder, "experiments_of_session.py")
    with open(carried, "w", encoding="utf-8") as file:
        file.write("import pickle\nimport sys\n\n"
                   f"sys.path += [one for one in {sys.path!r} if one not in sys.path]\n"
                   f"experiments = pickle.loads({pickled.getvalue()!r})\n"
                   "globals().update({f'experiment_{number}': one for number, one in enumerate(experiments)})\n")
    return [*files, carried]


def window(session, experiments=()):
    """Opens the native window on a session, and returns a `Window` at once.

    The window has the structures and layers of the session, too: their functions go there with cloudpickle.

    experiments
        more of them, evolutions too; or files, as those of ``--with``, which the window loads again whenever they change
    """
    out = Window(session, experiments)
    session._windows.add(out)
    return out
