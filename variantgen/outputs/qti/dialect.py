"""The versions of QTI: the same model in other names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from xml.etree.ElementTree import Element

from msgspec import Struct

from variantgen.outputs.qti.xml_tree import element, fragment

XSI = "http://www.w3.org/2001/XMLSchema-instance"
LOM = "http://ltsc.ieee.org/xsd/LOM"
_LOM_SCHEMA = f"{LOM} http://www.imsglobal.org/xsd/imsmd_loose_v1p3p2.xsd"
_PURL = "https://purl.imsglobal.org/spec/qti/v3p0/schema/xsd"
# QTI 2.1 has the elements of XHTML 1.0.
_OLDER = {"figure": "div", "figcaption": "p"}
_CAPITAL = re.compile("([A-Z])")


class Dialect(Struct, frozen=True):
    """A version of QTI: namespaces with the places of their schemas, types of resources, how names are written.

    ``modern``: names like ``qti-item-body`` with the elements of HTML 5, not ``itemBody`` with those of XHTML.
    """

    name: str
    namespace: str
    schema: str
    packaging: str
    packaging_schema: str
    package: tuple[str, str]
    item: str
    test: str
    modern: bool

    def tag(self, name: str) -> str:
        """The name of an element of the model, which is that of QTI 2.1."""
        return f"qti-{_kebab(name)}" if self.modern else name

    def attributes(self, found: Mapping[str, str]) -> dict[str, str]:
        """The names of attributes; those of XML itself stay."""
        return {_kebab(name) if self.modern and ":" not in name else name: value for name, value in found.items()}

    def element(self, name: str, attributes: Mapping[str, str] | None = None, *content: str | Element) -> Element:
        """An element of the model."""
        return element(self.tag(name), self.attributes(attributes or {}), *content)

    def root(self) -> dict[str, str]:
        """The attributes of the root of an item or a test that name the version."""
        return {"xmlns": self.namespace, "xmlns:xsi": XSI, "xsi:schemaLocation": f"{self.namespace} {self.schema}"}

    def manifest(self) -> dict[str, str]:
        """The attributes of the root of a manifest."""
        places = f"{self.packaging} {self.packaging_schema} {_LOM_SCHEMA}"
        return {"xmlns": self.packaging, "xmlns:imsmd": LOM, "xmlns:xsi": XSI, "xsi:schemaLocation": places}

    def html(self, text: str) -> list[Element]:
        """Elements of HTML as far as the version knows them."""
        found = fragment(text)
        if not self.modern:
            for one in (one for top in found for one in top.iter()):
                one.tag = _OLDER.get(one.tag, one.tag)
        return found

    def feedback(self, attributes: Mapping[str, str], content: Element) -> Element:
        """What is shown after an attempt."""
        inner = self.element("contentBody", {}, content) if self.modern else content
        return self.element("modalFeedback", attributes, inner)

    def rubric(self, content: Element) -> Element:
        """What candidates read above the items of a section."""
        inner = self.element("contentBody", {}, content) if self.modern else content
        purpose = {"use": "instructions"} if self.modern else {}
        return self.element("rubricBlock", {**purpose, "view": "candidate"}, inner)


def _kebab(name: str) -> str:
    return _CAPITAL.sub(r"-\1", name).lower()


QTI21 = Dialect(
    name="qti21",
    namespace="http://www.imsglobal.org/xsd/imsqti_v2p1",
    schema="http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd",
    packaging="http://www.imsglobal.org/xsd/imscp_v1p1",
    packaging_schema="http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd",
    package=("QTIv2.1 Package", "1.0.0"),
    item="imsqti_item_xmlv2p1",
    test="imsqti_test_xmlv2p1",
    modern=False,
)
QTI30 = Dialect(
    name="qti30",
    namespace="http://www.imsglobal.org/xsd/imsqtiasi_v3p0",
    schema=f"{_PURL}/imsqti_asiv3p0_v1p0.xsd",
    packaging="http://www.imsglobal.org/xsd/qti/qtiv3p0/imscp_v1p1",
    packaging_schema=f"{_PURL}/imsqtiv3p0_imscpv1p2_v1p0.xsd",
    package=("QTI Package", "3.0.0"),
    item="imsqti_item_xmlv3p0",
    test="imsqti_test_xmlv3p0",
    modern=True,
)
