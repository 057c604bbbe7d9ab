"""What springs and joints do, and what leads masses."""
