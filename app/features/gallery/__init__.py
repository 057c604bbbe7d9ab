"""The gallery: all scenes on cards."""
