"""The command: wrong options have a message, and so has a missing package."""

from __future__ import annotations

import asyncio
import socket
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from variantgen.cli import main
from variantgen.studio.server import listening


@pytest.mark.parametrize("package", ["starlette", "uvicorn"])
def test_a_missing_package_is_named(package: str, tmp_path: Path) -> None:
    script = (
        f"import sys; sys.modules[{package!r}] = None; from variantgen.cli import main; sys.exit(main(sys.argv[1:]))"
    )
    command = [sys.executable, "-c", script, "studio", str(tmp_path), "--no-browser"]
    run = subprocess.run(command, capture_output=True, text=True, check=False, timeout=60)
    assert run.returncode == 3 and package in run.stderr and ".[studio]" in run.stderr, run.stderr


@pytest.mark.parametrize(("words", "named"), [(["nowhere"], "nowhere"), ([".", "--port", "70000"], "--port")])
def test_wrong_options_have_a_message(words: list[str], named: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["studio", *words, "--no-browser"]) == 2
    assert named in capsys.readouterr().err


def test_answers_do_not_wait_for_acknowledgements() -> None:
    """A head and a body that are sent apart leave at once (a figure would come 40 ms later)."""

    async def without_delay() -> int:
        options = asyncio.get_running_loop().create_future()

        def connected(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            options.set_result(writer.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
            writer.close()

        async with await asyncio.start_server(connected, sock=listening(0)) as server:
            _, writer = await asyncio.open_connection(*server.sockets[0].getsockname())
            found = int(await options)
            writer.close()
        return found

    with ThreadPoolExecutor(1) as pool:  # a browser that is open keeps the loop of this thread
        assert pool.submit(lambda: asyncio.run(without_delay())).result() != 0
