"""A quiz of Canvas around its questions: the document of questions, what Canvas wants to know of a quiz, its resources.

A quiz is a folder of its identifier with two files. See :mod:`variantgen.outputs.qti.canvas_item` for the questions.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from decimal import Decimal
from xml.etree.ElementTree import Element

from variantgen.exam.exam import Exam
from variantgen.outputs.platforms.numbers import number
from variantgen.outputs.qti.canvas_item import field
from variantgen.outputs.qti.dialect import XSI
from variantgen.outputs.qti.options import introduction
from variantgen.outputs.qti.outline import Outline
from variantgen.outputs.qti.xml_tree import element

QTI = {
    "xmlns": "http://www.imsglobal.org/xsd/ims_qtiasiv1p2",
    "xmlns:xsi": XSI,
    "xsi:schemaLocation": "http://www.imsglobal.org/xsd/ims_qtiasiv1p2 "
    "http://www.imsglobal.org/xsd/ims_qtiasiv1p2p1.xsd",
}
_CANVAS = "http://canvas.instructure.com/xsd/cccv1p0"
_META = {
    "xmlns": _CANVAS,
    "xmlns:xsi": XSI,
    "xsi:schemaLocation": f"{_CANVAS} https://canvas.instructure.com/xsd/cccv1p0.xsd",
}
_PACKAGING = "http://www.imsglobal.org/xsd/imsccv1p1/imscp_v1p1"
_METADATA = "http://www.imsglobal.org/xsd/imsmd_v1p2"
_MANIFEST = {
    "xmlns": _PACKAGING,
    "xmlns:imsmd": _METADATA,
    "xmlns:xsi": XSI,
    "xsi:schemaLocation": f"{_PACKAGING} http://www.imsglobal.org/xsd/imscp_v1p1.xsd {_METADATA} "
    "http://www.imsglobal.org/xsd/imsmd_v1p2p2.xsd",
}
_SETTINGS = "associatedcontent/imscc_xmlv1p1/learning-application-resource"


def question_file(name: str) -> str:
    """The document of the questions of a quiz."""
    return f"{name}/{name}.xml"


def meta_file(name: str) -> str:
    """The document of the settings of a quiz."""
    return f"{name}/assessment_meta.xml"


def whole(name: str, title: str, items: Iterable[Element]) -> Element:
    """The document of a quiz with these questions."""
    section = element("section", {"ident": "root_section"}, *items)
    return element("questestinterop", QTI, element("assessment", {"ident": name, "title": title}, attempts(), section))


def attempts() -> Element:
    """Metadata of a quiz: one attempt."""
    return element("qtimetadata", {}, field("cc_maxattempts", "1"))


def pick(points: Decimal) -> Element:
    """How a group of questions is used: each student gets one of them."""
    extension = element("selection_extension", {}, element("points_per_item", {}, number(points)))
    return element(
        "selection_ordering",
        {},
        element("selection", {}, element("selection_number", {}, "1"), extension),
    )


def meta(name: str, title: str, exam: Exam, points: Decimal, assigned: bool) -> Element:
    """The settings of a quiz; ``assigned``: nobody sees it but those whom it is assigned to."""
    explained = _yes(exam.solutions.wanted)
    fields = {
        "title": title,
        "description": introduction(exam),
        "shuffle_answers": "false",
        "scoring_policy": "keep_highest",
        "hide_results": "",
        "quiz_type": "assignment",
        "points_possible": number(points),
        "show_correct_answers": explained,
        "anonymous_submissions": "false",
        "allowed_attempts": "1",
        "one_question_at_a_time": "false",
        "cant_go_back": "false",
        "available": "false",
        "one_time_results": "false",
        "show_correct_answers_last_attempt": "false",
        "only_visible_to_overrides": _yes(assigned),
    }
    return element("quiz", {**_META, "identifier": name}, *_fields(fields), _assignment(name, title, points, assigned))


def _assignment(name: str, title: str, points: Decimal, assigned: bool) -> Element:
    fields = {
        "title": title,
        "workflow_state": "unpublished",
        "quiz_identifierref": name,
        "points_possible": number(points),
        "grading_type": "points",
        "submission_types": "online_quiz",
        "only_visible_to_overrides": _yes(assigned),
    }
    return element("assignment", {"identifier": f"{name}-assignment"}, *_fields(fields))


def _fields(found: Mapping[str, str]) -> Iterator[Element]:
    return (element(name, {}, text) for name, text in found.items())


def _yes(value: bool) -> str:
    return "true" if value else "false"


@contextmanager
def resources(outline: Outline, name: str, title: str, language: str) -> Iterator[None]:
    """The manifest; what is written inside the block are its resources."""
    with outline.inside("manifest", {"identifier": name, **_MANIFEST}):
        named = element("imsmd:title", {}, element("imsmd:langstring", {"xml:lang": language}, title))
        about = element("imsmd:general", {}, named, element("imsmd:language", {}, language))
        outline.add(
            element(
                "metadata",
                {},
                element("schema", {}, "IMS Content"),
                element("schemaversion", {}, "1.1.3"),
                element("imsmd:lom", {}, about),
            )
        )
        outline.add(element("organizations"))
        with outline.inside("resources"):
            yield


def quiz_resources(name: str) -> Iterator[Element]:
    """The two resources of a quiz."""
    settings = f"{name}-meta"
    questions = {"identifier": name, "type": "imsqti_xmlv1p2"}
    depends = element("dependency", {"identifierref": settings})
    yield element("resource", questions, element("file", {"href": question_file(name)}), depends)
    yield _resource(settings, _SETTINGS, meta_file(name))


def picture(file: str) -> Element:
    """The resource of a figure."""
    return _resource(f"f{file.rpartition('/')[2].partition('.')[0]}", "webcontent", file)


def _resource(name: str, kind: str, file: str) -> Element:
    return element("resource", {"identifier": name, "type": kind, "href": file}, element("file", {"href": file}))
