"""Controls made of viser's, and what the script does to viser's page: hook, connection, widgets."""
