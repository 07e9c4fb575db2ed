"""Writing of PDFs that are joined of parts, with memory for one part at a time.

A library would hold all objects of the whole: with tags about 10 MB for the solutions of one student.
"""
