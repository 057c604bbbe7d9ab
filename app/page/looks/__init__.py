"""How the page looks: styles, texts, menus and dialogs."""
