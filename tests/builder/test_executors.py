"""Who does the work changes nothing: threads, processes of all kinds, a cluster that loses a worker."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.builder.small_exams import TEXT, content, exam, exam_file
from variantgen.builder import WorkerLostError, build, kept, scheduled_workers
from variantgen.builder.build_spec import OtherVersionError
from variantgen.builder.sealed import write
from variantgen.builder.workers import PoolWorkers, local_workers
from variantgen.cli import main
from variantgen.errors import InputError
from variantgen.exam.exam import Exam
from variantgen.exam.roster import numbered
from variantgen.skeletons import new_family

STUDENTS = 50  # a job of drawing for each problem, four parts, four overviews


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """What a build in one process makes."""
    folder = tmp_path_factory.mktemp("reference")
    build(exam(folder), numbered(STUDENTS), folder / "out")
    return content(folder / "out")


@pytest.mark.parametrize("kind", ["threads", "fork", "spawn", "forkserver"])
def test_any_executor_makes_the_same_bytes(kind: str, reference: dict[str, bytes], tmp_path: Path) -> None:
    executor: Executor
    if kind == "threads":
        executor = ThreadPoolExecutor(3)
    elif kind == "fork":
        # Before anything else has started threads in this process: a process of its own does it.
        command = [sys.executable, "-m", "variantgen", "build", str(exam_file(tmp_path)), "--variants", str(STUDENTS)]
        subprocess.run([*command, "--out", str(tmp_path / "out"), "--jobs", "3"], check=True, capture_output=True)
        assert content(tmp_path / "out") == reference
        return
    else:
        executor = ProcessPoolExecutor(2, multiprocessing.get_context(kind))
    with executor:
        build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", executor=executor)
    assert content(tmp_path / "out") == reference


@pytest.mark.parametrize("foreign", [False, True])
def test_who_shares_the_disk_writes_there(
    foreign: bool, reference: dict[str, bytes], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here: list[int] = []
    real = write

    def noted(folder: Path, name: str, content: bytes, key: bytes | None = None) -> None:
        here.extend([os.getpid()] if name.startswith(("made/", "drawn/")) else ())
        real(folder, name, content, key)

    monkeypatch.setattr(kept, "write", noted)
    executor = ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) if foreign else None
    build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", jobs=2, executor=executor)
    assert content(tmp_path / "out") == reference
    assert bool(here) == foreign, "only what comes from workers with another disk is written by this process"


def test_processes_of_a_program_that_has_used_the_engine(reference: dict[str, bytes], tmp_path: Path) -> None:
    # A fork would copy the engine without its threads, and wait for them for ever.
    build(exam(tmp_path), numbered(3), tmp_path / "first")
    build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", jobs=2)
    assert content(tmp_path / "out") == reference


class Cluster:
    """A Dask cluster on this machine; its workers are processes in a folder of their own."""

    def __init__(self, folder: Path, workers: int) -> None:
        from distributed import LocalCluster

        self.cluster = LocalCluster(
            n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=":0", local_directory=str(folder)
        )
        self.address: str = self.cluster.scheduler_address

    def kill_one(self) -> None:
        """Kill a worker outright."""
        worker = next(iter(self.cluster.workers.values()))
        os.kill(worker.pid, signal.SIGKILL)


@pytest.fixture(scope="module")
def cluster(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Cluster]:
    found = Cluster(tmp_path_factory.mktemp("workers"), 3)
    yield found
    found.cluster.close()


def test_a_cluster_that_loses_a_worker(cluster: Cluster, reference: dict[str, bytes], tmp_path: Path) -> None:
    killed: list[int] = []

    def progress(stage: str, done: int, total: int) -> None:
        if stage == "typesetting" and 0 < done < total and not killed:
            killed.append(done)
            cluster.kill_one()

    with scheduled_workers(cluster.address) as workers:
        build(exam(tmp_path), numbered(STUDENTS), tmp_path / "out", executor=workers, progress=progress)
    assert killed
    assert content(tmp_path / "out") == reference


def test_the_command_line_finds_the_cluster(
    cluster: Cluster, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    # A family of one's own, which the workers do not have: it comes with the exam.
    new_family("my_family", tmp_path)
    path = exam_file(tmp_path, TEXT + '[[problem]]\nfamily = "my_family"\n')
    arguments = ["build", str(path), "--variants", "9", "--out"]
    assert main([*arguments, str(tmp_path / "one")]) == 0
    assert main([*arguments, str(tmp_path / "two"), "--scheduler", cluster.address]) == 0
    assert content(tmp_path / "one") == content(tmp_path / "two")
    with pytest.raises(SystemExit, match="2"):
        main([*arguments, str(tmp_path / "three"), "--scheduler", cluster.address, "--jobs", "2"])
    assert "--jobs" in capsys.readouterr().err


def test_no_scheduler(tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("variantgen.builder.workers.PATIENCE", 1)
    arguments = ["build", str(exam_file(tmp_path)), "--variants", "1", "--out", str(tmp_path / "out")]
    assert main([*arguments, "--scheduler", "tcp://127.0.0.1:9"]) == 2
    said = capsys.readouterr().err
    assert "--scheduler" in said
    assert "tcp://127.0.0.1:9" in said
    assert main([*arguments, "--scheduler", "not an address"]) == 2
    assert not (tmp_path / "out").exists()


def ended() -> None:
    os._exit(1)


class Losing(Executor):
    """Loses its worker when it is given the third job."""

    def __init__(self, pool: ProcessPoolExecutor) -> None:
        self.pool, self.jobs = pool, 0

    def submit(self, fn, /, *args, **kwargs):  # type: ignore[no-untyped-def]
        self.jobs += 1
        return self.pool.submit(ended) if self.jobs == 3 else self.pool.submit(fn, *args, **kwargs)


def test_a_lost_worker_is_told_and_the_build_goes_on_later(reference: dict[str, bytes], tmp_path: Path) -> None:
    out = tmp_path / "out"
    pool = ProcessPoolExecutor(1, multiprocessing.get_context("forkserver"))
    with pool, pytest.raises(WorkerLostError, match="memory"):
        build(exam(tmp_path), numbered(STUDENTS), out, executor=Losing(pool))
    assert not out.exists()
    build(exam(tmp_path), numbered(STUDENTS), out, resume=True)
    assert content(out) == reference


def test_workers_that_have_all_gone_are_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The scheduler would wait for new ones for ever, without a word."""
    monkeypatch.setattr("variantgen.builder.workers.ABSENCE", 1)
    out, own = tmp_path / "out", Cluster(tmp_path / "workers", 1).cluster

    def progress(stage: str, done: int, total: int) -> None:
        if stage == "typesetting" and done == 0:
            own.scale(0)

    with (
        own,
        scheduled_workers(own.scheduler_address) as workers,
        pytest.raises(WorkerLostError, match="no worker has been there"),
    ):
        build(exam(tmp_path), numbered(STUDENTS), out, executor=workers, progress=progress)
    assert not out.exists()
    assert (tmp_path / ".out.unfinished" / "plan.json").exists(), "one can go on"


def test_workers_that_are_slow_are_waited_for(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    asked: list[int] = []

    def there() -> bool:
        asked.append(1)
        return len(asked) % 3 != 0  # away for a moment

    class Slow(ThreadPoolExecutor):
        def submit(self, fn, /, *args, **kwargs):  # type: ignore[no-untyped-def]
            return super().submit(lambda: (time.sleep(0.4), fn(*args, **kwargs))[1])

    monkeypatch.setattr("variantgen.builder.workers.ABSENCE", 0.3)
    with Slow(1) as executor:
        build(exam(tmp_path), numbered(3), tmp_path / "out", executor=PoolWorkers(executor, 4, there))
    assert len(asked) > 3


def test_workers_of_another_version_are_refused(tmp_path: Path) -> None:
    from variantgen.builder.build_spec import BuildSpec

    spec = BuildSpec.of(replace(exam(tmp_path), seed="1"))
    assert spec.exam(tmp_path).title == "Quiz"
    with pytest.raises(OtherVersionError, match=r"0\.0 "):
        replace(spec, made_with={**spec.made_with, "program": "0.0 of another time"}).exam(tmp_path)


def test_an_exam_that_is_not_that_of_its_text_cannot_be_carried(tmp_path: Path) -> None:
    from variantgen.builder.build_spec import BuildSpec

    whole = exam(tmp_path)
    changed: Exam = replace(whole, tasks=whole.tasks[:1])
    with pytest.raises(OtherVersionError, match="changed"):
        BuildSpec.of(replace(changed, seed="1")).exam(tmp_path)
    # In this process nothing is read again.
    build(changed, numbered(2), tmp_path / "out")


def test_errors_come_back_from_workers(tmp_path: Path) -> None:
    text = TEXT + '[[problem]]\nfamily = "four_bar"\nform = "crank"\nset = { OA = 16, AB = 30, BC = 24, OC = 100 }\n'
    pool = ProcessPoolExecutor(1, multiprocessing.get_context("forkserver"))
    with pool, pytest.raises(InputError, match="no valid variant") as caught:
        build(exam(tmp_path, text), numbered(3), tmp_path / "out", executor=pool)
    assert "exam.toml" in str(caught.value)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["exam.toml"], "what would fail again is not kept"


def test_threads_take_turns(tmp_path: Path) -> None:
    """The engine has but one memory: jobs in one process come one after the other."""
    from variantgen.builder.build_spec import BuildSpec, worker_context

    spec = BuildSpec.of(replace(exam(tmp_path), seed="1"))
    inside = 0

    def enter() -> None:
        nonlocal inside
        with worker_context(spec):
            inside += 1
            assert inside == 1
            inside -= 1

    threads = [threading.Thread(target=enter) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()


def test_a_block_ends_though_workers_are_killed_while_they_send() -> None:
    """What was half sent is waited for by nobody: 60 MB take a pipe long enough for the next to be on its way."""

    def interrupted() -> None:
        with pytest.raises(KeyboardInterrupt), local_workers(2) as workers:
            assert isinstance(workers, PoolWorkers)
            first, *_ = [workers.executor.submit(bytes, 60_000_000) for _ in range(8)]
            first.result()
            raise KeyboardInterrupt

    for _ in range(3):
        thread = threading.Thread(target=interrupted, daemon=True)
        thread.start()
        thread.join(30)
        assert not thread.is_alive()
