"""Small scenes as files of TOML, which tests of messages change in one place."""

from __future__ import annotations

# A crank of 20 cm at 30 degrees, without a driver.
FREE_CRANK = """
length_unit = "cm"
[points]
O = { coordinates = { x = 0, y = 0 } }
A = { polar = { origin = "O", distance = 20, angle = 30 } }
[bodies]
OA = ["O", "A"]
[[joints]]
pivot = { point = "O" }
"""
CRANK = f"""{FREE_CRANK}[[drivers]]
rotation = {{ body = "OA", omega = 2 }}
"""
