"""Who does the jobs: this process, processes beside it, or any executor that somebody else provides."""

from __future__ import annotations

import importlib.util
import os
import pickle
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

from msgspec import Struct

from variantgen.builder.build_spec import BuildSpec
from variantgen.builder.jobs import CallJob, Job, KeepJob, perform
from variantgen.builder.kept import KeptParts
from variantgen.errors import InputError, Problem, VariantgenError, missing_package

if TYPE_CHECKING:
    # Loaded where they are used: a build in one process needs neither.
    from concurrent.futures import Executor, Future

_Key = TypeVar("_Key")
PATIENCE = 10  # seconds in which a scheduler must answer
# A worker that was killed may come back by itself: for so many seconds nobody needs to be there.
ABSENCE = 60


class WorkerLostError(VariantgenError):
    """A process that did jobs is gone."""

    may_pass = True


class Workers(Protocol):
    """Who does jobs; ``share_disk`` says whether they surely see the files that this process does."""

    @property
    def share_disk(self) -> bool:
        """Whether they do."""

    def run(self, spec: BuildSpec, jobs: Iterable[tuple[_Key, Job]]) -> Iterator[tuple[_Key, Any]]:
        """Do jobs; results come with the keys of the jobs, in the order in which they are ready."""


class InlineWorkers:
    """Does every job at once, in this process."""

    share_disk = True

    def run(self, spec: BuildSpec, jobs: Iterable[tuple[_Key, Job]]) -> Iterator[tuple[_Key, Any]]:
        """Do jobs one after another."""
        for key, job in jobs:
            yield key, perform(spec, job)


class PoolWorkers(Struct, frozen=True):
    """An executor and how many jobs it is given at a time: more would only be held in memory.

    ``there`` says whether anybody is there who could do a job; where it cannot be known, it is taken to be so.
    """

    executor: Executor
    ahead: int
    there: Callable[[], bool] = lambda: True
    share_disk: bool = False

    def run(self, spec: BuildSpec, jobs: Iterable[tuple[_Key, Job]]) -> Iterator[tuple[_Key, Any]]:
        """Do jobs; results come with the keys of the jobs, in the order in which they are ready.

        Raises WorkerLostError when a process has died or nobody has been there for long.
        """
        pending: dict[Future[Any], _Key] = {}
        try:
            for key, job in jobs:
                # Pickled here: process pools ask a table in Python about every object that they pickle.
                pending[self.executor.submit(_perform, pickle.dumps((spec, job)))] = key
                while len(pending) >= self.ahead:
                    yield from self._ready(pending)
            while pending:
                yield from self._ready(pending)
        except Exception as error:
            if _is_loss(error):
                what = "a worker ended before its work was done; was there enough memory?"
                raise WorkerLostError(f"{what} ({error or type(error).__name__})") from error
            raise
        finally:
            for future in pending:
                future.cancel()

    def _ready(self, pending: dict[Future[Any], _Key]) -> Iterator[tuple[_Key, Any]]:
        """The results that come next. Raises WorkerLostError when nobody has been there for long."""
        from concurrent.futures import FIRST_COMPLETED, wait

        seen = time.monotonic()
        while not (done := wait(pending, ABSENCE / 6, return_when=FIRST_COMPLETED).done):
            if self.there():
                seen = time.monotonic()
            elif time.monotonic() - seen > ABSENCE:
                raise WorkerLostError(f"no worker has been there for {ABSENCE} seconds: start some again")
        for future in done:
            key = pending.pop(future)
            yield key, future.result()


def run_and_keep(
    workers: Workers, spec: BuildSpec, kept: KeptParts, jobs: Iterable[tuple[_Key, Job]]
) -> Iterator[tuple[_Key, Any]]:
    """Do jobs, and keep what they have made at the places that are their keys; what has to be known besides.

    Workers on this disk write there themselves: a part is large, and this process has all of them on its hands.
    """
    if workers.share_disk:
        yield from workers.run(spec, ((place, KeepJob(job, kept, place)) for place, job in jobs))
    else:
        for place, made in workers.run(spec, jobs):
            yield place, made.keep(kept, place)


def in_order_by(
    workers: Workers, spec: BuildSpec, function: Callable[[Any], Any], given: Iterable[Any]
) -> Iterator[Any]:
    """What a function of a module returns for things that are given, in their order: the :class:`Run` of workers.

    It works on files, so this process does it where workers may have another disk.
    """
    if not workers.share_disk:
        yield from map(function, given)
        return
    early: dict[int, Any] = {}
    following = 0
    for place, found in workers.run(spec, ((place, CallJob(function, one)) for place, one in enumerate(given))):
        early[place] = found
        while following in early:
            yield early.pop(following)
            following += 1


def _perform(pickled: bytes) -> Any:
    """Do a job of a build; executors are given this function."""
    return perform(*pickle.loads(pickled))  # noqa: S301  (from the process that has sent the job)


def _is_loss(error: Exception) -> bool:
    """Whether an error tells of the executor, not of a job."""
    from concurrent.futures import BrokenExecutor, CancelledError

    package = type(error).__module__.partition(".")[0]
    return isinstance(error, BrokenExecutor | CancelledError) or package == "distributed"


@contextmanager
def local_workers(processes: int) -> Iterator[Workers]:
    """The calling process alone or so many beside it, which end with the block, and when this process is killed."""
    if processes <= 1:
        yield InlineWorkers()
        return
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    others = set(multiprocessing.active_children())
    with ProcessPoolExecutor(processes, _context(), initializer=_leave_with_parent) as pool:
        try:
            yield PoolWorkers(pool, 2 * processes + 2, share_disk=True)
        except BaseException:
            # Nobody waits for what is being done.
            for worker in set(multiprocessing.active_children()) - others:
                worker.kill()
            # One that was sending a result has left half of it in the pipe. The thread that reads it would wait for the
            # rest as long as anybody could still write there, and this process could.
            pool._result_queue._writer.close()  # type: ignore[attr-defined]
            pool.shutdown(cancel_futures=True)
            raise


def _context() -> Any:
    """How processes are begun: forked, which takes no time, where nothing in this process can be harmed by it.

    The engine has threads of its own as soon as it is used, and a fork copies what they hold, but not them.
    """
    import multiprocessing

    methods = multiprocessing.get_all_start_methods()
    engine_is_free = "typst" not in sys.modules and threading.active_count() == 1
    if "fork" in methods and engine_is_free:
        return multiprocessing.get_context("fork")
    if "forkserver" in methods:
        context = multiprocessing.get_context("forkserver")
        context.set_forkserver_preload([perform.__module__])
        return context
    return multiprocessing.get_context("spawn")


def _leave_with_parent() -> None:
    """Let a worker end when the program is killed, so that nothing is left running; Ctrl-C is the program's."""
    import multiprocessing.connection

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(
            target=lambda: (multiprocessing.connection.wait([parent.sentinel]), os._exit(1)), daemon=True
        ).start()


@contextmanager
def scheduled_workers(address: str) -> Iterator[PoolWorkers]:
    """The workers of a Dask scheduler. Raises ToolMissingError without its client, InputError if nobody answers."""
    if importlib.util.find_spec("distributed") is None:
        raise missing_package("--scheduler needs", "distributed", "dask")
    from distributed import Client

    try:
        client = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as error:
        remedy = "is the scheduler running, and its address as it prints it?"
        problem = Problem(f"no scheduler answers: {error}", key="--scheduler", value=address, remedy=remedy)
        raise InputError(problem) from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            remedy = "start some:  dask worker " + address
            raise InputError(Problem("the scheduler has no workers", key="--scheduler", value=address, remedy=remedy))
        # A job that was lost with its worker is given to another one.
        with client.get_executor(pure=False, retries=3) as executor:
            yield PoolWorkers(executor, 2 * threads + 2, lambda: _has_workers(client))


def _has_workers(client: Any) -> bool:
    """Whether a scheduler has workers, and answers."""
    try:
        return bool(client.nthreads())
    except (OSError, TimeoutError):
        return False
