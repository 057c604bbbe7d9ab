"""`softrod fit`: a scene is fitted to what was measured."""
