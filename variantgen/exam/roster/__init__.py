"""The class list: CSV or XLSX as it comes, columns in any order, in Russian or English, with or without ids."""

from variantgen.exam.roster.reading import Roster, read_class, read_roster
from variantgen.exam.roster.student import Student, numbered

__all__ = ["Roster", "Student", "numbered", "read_class", "read_roster"]
