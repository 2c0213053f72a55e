# SPDX-License-Identifier: GPL-3.0-or-later
"""One function for many files, one after another or by an executor."""
import concurrent.futures
import typing


class Result(typing.NamedTuple):
    """The result of one item."""

    item: typing.Any  #: as it was given
    value: typing.Any  #: that the function returned; None if it raised an exception
    error: typing.Optional[Exception]  #: that it raised


def map(function, items, executor=None):
    """Calls a function for each item, and yields a `Result` for each as soon as it is known, in any order.

    function
        of one item, such as the name of a file. For processes and clusters it has to be importable there; it and its results are
        pickled, as a session can be
    items
        any iterable
    executor
        None: items are done one after another, here. Otherwise anything with the method ``submit`` of
        ``concurrent.futures``: a ``ProcessPoolExecutor``,
        ``client.get_executor()`` of Dask, an ``MPIPoolExecutor`` of mpi4py

    An exception of the function, or the loss of a worker, is the result of the item, and the other items go on. Calls
    that have not begun are cancelled when the iteration ends early.
    """
    if executor is None:
        for item in items:
            yield _result(item, lambda: function(item))
        return
    futures = {executor.submit(function, item): item for item in items}
    try:
        for future in concurrent.futures.as_completed(futures):
            yield _result(futures[future], future.result)
    finally:
        for future in futures:
            future.cancel()


def _result(item, work):
    try:
        return Result(item, work(), None)
    except Exception as error:  # noqa: BLE001 - the exception of the function is its result
        return Result(item, None, error)
