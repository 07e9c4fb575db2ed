"""A build that is interrupted while it takes its folder of parts leaves none."""

from __future__ import annotations

from pathlib import Path

import pytest

from variantgen.builder import folder_lock as module
from variantgen.errors import InputError


def interrupted(file: int) -> bool:
    raise KeyboardInterrupt


def test_an_interrupt_before_the_lock_leaves_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real, calls = module._is_locked, [interrupted]
    monkeypatch.setattr(module, "_is_locked", lambda file: calls.pop()(file) if calls else real(file))
    folder = tmp_path / ".out.unfinished"
    with pytest.raises(KeyboardInterrupt), module.locked_folder(folder, tmp_path / "out"):
        pass
    assert list(tmp_path.iterdir()) == []


def test_an_interrupt_leaves_the_folder_of_another_build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / ".out.unfinished"
    with module.locked_folder(folder, tmp_path / "out"):
        with monkeypatch.context() as patched:
            patched.setattr(module, "_is_locked", interrupted)
            with pytest.raises(KeyboardInterrupt), module.locked_folder(folder, tmp_path / "out"):
                pass
        assert [path.name for path in folder.iterdir()] == [module.LOCK]
        with pytest.raises(InputError, match="another build"), module.locked_folder(folder, tmp_path / "out"):
            pass
    assert not folder.exists()
