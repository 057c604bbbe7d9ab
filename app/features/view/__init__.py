"""How the page looks: the View menu, and the help."""
