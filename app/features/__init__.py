"""What a page can do, a folder each; `app.page.features` names them."""
