"""The studio: exams by sight, in a browser, on the instructor's own machine (the extra ``studio``).

Only :mod:`variantgen.cli.commands.studio` imports it, and only when it is asked for. ``server`` opens a port of this
machine, ``security`` decides who may speak to it, ``documents`` changes exam files, ``pages`` holds one module for each
page, ``assets`` what browsers are given: pages, words, style and scripts.
"""
