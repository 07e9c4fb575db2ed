"""How much work a variant is, and the draw of variants that are equally hard."""
