"""A scene in motion: running a method, driving masses, the energy balance, stability and divergence."""
