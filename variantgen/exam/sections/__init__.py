"""What the tables and keys of an exam file say, each read by a module here; ``exam_file`` puts them together."""
