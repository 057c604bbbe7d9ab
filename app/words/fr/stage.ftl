stage-away = L’objet est hors de vue. Montrer toute la scène
stage-drag = tire-moi
stage-empty = Rien n’est encore construit ici.
    .draw = Dessiner un objet
    .tap = Touche pour placer une masse. Glisse depuis une masse pour un ressort.
    .click = Clique pour placer une masse. Glisse depuis une masse pour un ressort.
    .taps = Touche pour placer une masse. Touche une masse, puis une autre, pour un ressort.
