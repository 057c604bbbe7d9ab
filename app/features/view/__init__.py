"""The looks of the page: the View menu, and the help."""
