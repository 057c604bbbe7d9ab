"""`softrod stability`: where each method breaks."""
