"""Problems and solutions as fragments of HTML, for pages and for learning platforms."""
