"""What a page can do, a folder each; `app.pages.sandbox.features` names them."""
