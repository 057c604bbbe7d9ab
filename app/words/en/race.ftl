# A race of bodies: its strip over the bar of time, its marks and its dialog. A body is called by the name of its
# scene, and one's own "yours"; $own: whether it is that one.

race-strip = Race
race-rule = All start together, on this body's terrain, and the middle of each counts at the finish. Changes of this body and of the terrain are allowed, and are noted here; Race again makes it fair.
# Choosing a body to race against.
race-choose = Race against
    .paste = Paste a link, or choose below
    .link = Link to the scene to race against
    .go = Race
# Buttons.
race-start = Start
    .hint = All from the start, after a count-down
    .again = Race again
race-add = Add
    .hint = Another body joins the race
race-leave = Leave
    .hint = Leave the race; this body goes on alone
# The end of the count-down 3, 2, 1.
race-go = Go!
# For a screen reader; $start: the button and its key.
race-begins = A race against { $names }. { $start }.
race-left = The race is left
# Names of bodies, which have to differ.
race-own = { $name } (yours)
race-other = { $name } (the other)
race-yours = Yours

# The line above the bodies.
race-at-start = At the start
race-so-far = { $verdict }, after { $seconds } s
race-unfair = { $verdict }; changed or moved on the way
race-ahead = { $own ->
    [yes] Yours is ahead
   *[no] { $name } is ahead
}
race-ahead-by = { $own ->
    [yes] Yours is ahead by { $distance }
   *[no] { $name } is ahead by { $distance }
}
# Of two; many: of more.
race-close = Neither is ahead
    .many = None is ahead
race-is-first = { $own ->
    [yes] Yours is first, after { $seconds } s
   *[no] { $name } is first, after { $seconds } s
}
# First while others are still on their way.
race-was-first = { $own ->
    [yes] Yours was first, after { $seconds } s
   *[no] { $name } was first, after { $seconds } s
}
race-alone = { $own ->
    [yes] Yours was first; { $fates }
   *[no] { $name } was first; { $fates }
}
race-won = { $own ->
    [yes] Yours was first, by { $seconds } s
   *[no] { $name } was first, by { $seconds } s
}
# With more than two; $next: which came second.
race-won-before = { $own ->
    [yes] Yours was first, { $seconds } s before { $next }
   *[no] { $name } was first, { $seconds } s before { $nextOwn ->
        [yes] yours
       *[no] { $next }
    }
}
race-both = Both at once, after { $seconds } s
race-several = { $names } at once, after { $seconds } s
race-nobody = Nobody was first: { $fates }
# What has kept a body from the finish; one's own as the first word, or later.
race-exploded = { $who ->
    [first] Yours exploded
    [own] yours exploded
    [both] both exploded
    [all] all exploded
   *[other] { $name } exploded
}
race-fell = { $who ->
    [first] Yours fell
    [own] yours fell
    [both] both fell
    [all] all fell
   *[other] { $name } fell
}
race-away = { $who ->
    [first] Yours went the other way
    [own] yours went the other way
    [both] both went the other way
    [all] all went the other way
   *[other] { $name } went the other way
}
race-misfit = { $who ->
    [first] Yours does not fit this terrain
    [own] yours does not fit this terrain
    [both] both do not fit this terrain
    [all] all do not fit this terrain
   *[other] { $name } does not fit this terrain
}
race-late = { $who ->
    [first] Yours needed more than { $limit } s
    [own] yours needed more than { $limit } s
    [both] both needed more than { $limit } s
    [all] all needed more than { $limit } s
   *[other] { $name } needed more than { $limit } s
}

# Beside arrows and flags; $way: a distance, or how far away that is.
race-finish = Finish, { $way }
race-to = { $distance } ahead
    .behind = { $distance } behind
race-named = { $name }, { $way }

# Why a body cannot join.
race-full = { $count } bodies are as many as can be in a race
race-unknown = { $text } is neither a link to a scene nor the name of one
