"""What the features of a page are made of: commands, controls, panels, dialogs."""
