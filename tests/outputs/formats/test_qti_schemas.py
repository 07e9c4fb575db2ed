"""Packages of QTI against the official schemas, as a strict importer reads them.

``VARIANTGEN_QTI_SCHEMAS`` names a folder with the schemas of 1EdTech under their usual names: ``qti21/qtiv2p1/`` and
``qti30/``. Without it every document is only held against its namespaces.
"""

from __future__ import annotations

import os
import re
from functools import cache
from pathlib import Path

import pytest
from lxml import etree

from tests.outputs.formats.packages import build, exam, unpacked

VARIABLE = "VARIANTGEN_QTI_SCHEMAS"
FOLDER = os.environ.get(VARIABLE, "")
# The items and tests, and the manifest, of each version: the schema and the namespaces.
SCHEMAS = {
    "qti21": ("qti21/qtiv2p1/imsqti_v2p1.xsd", "qti21/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd"),
    "qti30": ("qti30/imsqti_asiv3p0_sbacv1p0_v1p0.xsd", "qti30/imsqtiv3p0_imscpv1p2_v1p0.xsd"),
}
NAMESPACES = {
    "qti21": ("http://www.imsglobal.org/xsd/imsqti_v2p1", "http://www.imsglobal.org/xsd/imscp_v1p1"),
    "qti30": ("http://www.imsglobal.org/xsd/imsqtiasi_v3p0", "http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1"),
}
OTHERS = {
    "http://www.w3.org/1998/Math/MathML",
    "http://ltsc.ieee.org/xsd/LOM",
    "http://www.imsglobal.org/xsd/imsmd_v1p2",
}
MANIFEST = "imsmanifest.xml"
CHECKS = ("namespaces", *(("schemas",) if FOLDER else ()))
# Wheels, gears, ropes, sleeves; rates, directions, senses, components; every method that writes more than formulas.
PROBLEMS = (
    'family = "sleeve_on_crank"\npoints = 10',
    'family = "four_bar"\nask = ["v_B.angle", "omega_AB.sense", "v_B.x"]\nmethod = "coordinates"',
    'family = "four_bar"\nask = ["v_B", "a_B"]\nmethod = "graphical"',
    'family = "planetary_train"',
    'family = "movable_pulley"',
    'family = "slider_crank"\nnice = true',
)
HEAD = 'formats = ["qti21", "qti30"]\ndate = "12 May"\ninstructions = "Take $g = 9.8$ <b>."'
OPTIONS = {
    "ru": '[solutions]\nlanguage = "en"',
    "en": "\n".join(
        f'[{name}]\ntests = "students"\nnames = true\nfigures = "svg"\nformulas = "html"' for name in SCHEMAS
    ),
}


@pytest.fixture(scope="module", params=["ru", "en"])
def out(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A build for two students in a language, each with other options."""
    language = request.param
    text = exam(*PROBLEMS, language=language, head=HEAD, tables=OPTIONS[language])
    return build(tmp_path_factory.mktemp("schemas") / language, text)


def documents(out: Path, version: str) -> dict[str, bytes]:
    found = {name: data for name, data in unpacked(out / f"{version}.zip").items() if name.endswith(".xml")}
    assert MANIFEST in found
    assert sum(name.startswith("i") and name != MANIFEST for name in found) == 2 * len(PROBLEMS)
    return found


@cache
def schema(path: str) -> etree.XMLSchema:
    return etree.XMLSchema(etree.parse(str(Path(FOLDER) / path)))


def in_namespaces(version: str, name: str, content: bytes) -> list[str]:
    """What stands in a namespace that it should not, or has no place of a schema."""
    tree = etree.fromstring(content)
    own = NAMESPACES[version][name == MANIFEST]
    wrong = [tag for tag in {str(one.tag) for one in tree.iter()} if etree.QName(tag).namespace not in {own, *OTHERS}]
    if etree.QName(tree).namespace != own:
        wrong.append(str(tree.tag))
    places = tree.get("{http://www.w3.org/2001/XMLSchema-instance}schemaLocation", "").split()
    if own not in places[::2] or not all(re.fullmatch(r"https?://\S+\.xsd", place) for place in places[1::2]):
        wrong.append(" ".join(places))
    return wrong


def in_schemas(version: str, name: str, content: bytes) -> list[str]:
    """What the official schema of a document has against it."""
    known = schema(SCHEMAS[version][name == MANIFEST])
    known.validate(etree.fromstring(content).getroottree())
    return [f"{error.line}: {error.message}" for error in known.error_log]


READERS = {"namespaces": in_namespaces, "schemas": in_schemas}


@pytest.mark.parametrize("version", sorted(SCHEMAS))
@pytest.mark.parametrize("check", CHECKS)
def test_every_document_is_valid(check: str, version: str, out: Path) -> None:
    found = {name: READERS[check](version, name, content) for name, content in documents(out, version).items()}
    assert {name: faults[:5] for name, faults in found.items() if faults} == {}


@pytest.mark.parametrize("version", sorted(SCHEMAS))
@pytest.mark.parametrize("check", CHECKS)
def test_the_reading_refuses_what_is_wrong(check: str, version: str, out: Path) -> None:
    for name, content in documents(out, version).items():
        tree = etree.fromstring(content)
        etree.SubElement(tree, "{http://example.org/other}strange").set("x", "1")
        assert READERS[check](version, name, etree.tostring(tree))
