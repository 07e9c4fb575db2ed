"""The folder of a build: complete or not there, nobody's work lost, the files of groups, the key and the manifest."""
