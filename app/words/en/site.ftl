# A gallery as a site: its index, and the bar of each page.

site-title = Ropes and soft bodies
site-about = Each picture opens a body that moves: drag it, bend it, change its numbers. It runs in the browser, and nothing is sent anywhere.
# Heading of scenes that do not ship with softrod.
site-own = Own scenes
site-find = Find a scene
site-count = { $count ->
    [one] { $count } scene
   *[other] { $count } scenes
}
site-found = { $count ->
    [one] { $found } of { $count } scene
   *[other] { $found } of { $count } scenes
}
site-none = No scene has all of these words.
site-unknown = There is no scene called { $name } here.
site-groups = Groups
site-dark = Dark page
site-made = Made with softrod. These pages need no server and no network.
# Of the index, once the browser has kept the whole gallery.
site-kept = All of it is on this device now, and opens here without a network.

# The bar.
site-bar = Gallery
site-all = All scenes
    .hint = All scenes (O)
site-before = Before: { $scene }
site-after = Next: { $scene }
site-save = Save this page as one file
