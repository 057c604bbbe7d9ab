access-title = Accès et langue
access-language = Langue
    .hint = Celle de la page ; tes propres scènes restent dans la leur. L’objet est gardé, et l’on peut toujours annuler.
access-letters = Lettres comme touches
    .hint = Pour qui dicte ses textes ou appuie sur des touches par erreur. Les touches avec Ctrl, les flèches et Échap agissent toujours.
    .always = toujours
    .body = tant que l’objet a le focus
    .never = jamais
access-taps = Toucher au lieu de glisser
    .hint = Touche un objet, puis l’endroit où il doit aller. Échap, ou une nouvelle touche sur l’objet, le remet à sa place. Glisser reste possible.
access-larger = Plus grand
    .hint = Tout en plus grand et en plus gras.
access-contrast = Plus de contraste
    .hint = Les lettres et les bords ressortent davantage.
access-still = Moins de mouvement
    .hint = Le vent, les vues et les repères ne bougent pas d’eux-mêmes. L’objet bouge quand on lance la simulation.
access-sound = Son
    .hint = Des graphiques, des modes, et de ce qui touche et se casse.
access-events = Annoncer les événements
    .hint = Un lecteur d’écran dit en peu de mots ce qui se passe : ce qui se casse, touche, s’arrête, est saisi ou lâché. Une phrase au plus toutes les deux secondes.
access-kept = Cet appareil garde ces réglages.

# While something is picked up by a tap, and after that; $thing is one of the names below, or that of an instrument, a
# bar or a mark.
taps-held = Pris : { $thing }. Touche l’endroit où le mettre. Échap, ou une touche dessus, le remet à sa place.
taps-put = Posé : { $thing }
taps-back = Remis en place : { $thing }
taps-nothing = Il n’y a rien à prendre ici ; un corps en pause est plus facile à toucher.
taps-button = Remettre
taps-selection = sélection
taps-frame = coin d’un cadre
taps-cut = fin d’une coupe
taps-turn = angle au repos d’une articulation
taps-picture = image
# Of a plot: the end of the part of the time that is to be shown larger.
taps-part = fin de la partie à agrandir
