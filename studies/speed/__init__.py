"""`softrod study`: computing time against error."""
