"""What can be done with a finished exam and its manifest: make a sheet again, verify every answer."""
