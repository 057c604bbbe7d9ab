# The page Access of the View menu.

access-title = Access and language
access-language = Language
    .hint = Of the page; texts of scenes and lessons stay in theirs. The body and what can be undone are kept.
access-letters = Letters as keys
    .hint = For those who speak their texts, or press keys by mistake. Keys with Ctrl, arrows and Esc always work.
    .always = always
    .body = while the body has the focus
    .never = never
access-larger = Larger
    .hint = Everything larger and bolder.
access-contrast = More contrast
    .hint = Letters and edges stand out more.
access-still = Less motion
    .hint = Wind, views and marks do not move by themselves. The body moves when it is played.
access-kept = This device keeps these settings.
