# The Play tab: the scene, its description and its sliders.

# The button with the scene's title, before it has one; hint: its tooltip, note: a line below the title.
play-scene = Scene
    .hint = choose another scene (key O)
    .note = Choose another scene
play-anew = Open anew
    .hint = open this scene anew
play-follow = Follow the pointer
    .hint = key F
play-more = More numbers
play-own = Scene's own values
# Instead of sliders; edit: the page has the tools that build.
play-held = Every mass of this scene is held.
    .edit = Every mass of this scene is held. Press Edit (E) to build more, or select a mass and let it go.
