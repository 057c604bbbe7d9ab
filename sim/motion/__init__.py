"""A scene in motion: what runs a method, who leads its masses, its energy, its limits."""
