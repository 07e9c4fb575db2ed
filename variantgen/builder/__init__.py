"""The main job: exam file and roster to a folder with sheets, key, solutions and manifest.

A build has three stages: every part of the students is drawn and solved; those who would have the same variant as
others draw again; every part is made in all outputs. The first and the last are jobs for any number of processes, in
the middle one only hashes are compared. Then the pieces are put together. What is done is kept until all is.
"""

from variantgen.builder.build import Built, Progress, build
from variantgen.builder.unfinished import unfinished_folder
from variantgen.builder.workers import WorkerLostError, scheduled_workers

__all__ = ["Built", "Progress", "WorkerLostError", "build", "scheduled_workers", "unfinished_folder"]
