view-menu = Affichage
    .hint = Affichage : sombre, vidéoprojecteur, aide et plus
view-help = Comment utiliser softrod
view-help-drag = <b>Tire</b> n’importe quelle masse. Les masses fixées restent où tu les laisses, les masses libres tombent. Fais glisser le papier pour le déplacer ; fais défiler ou pince pour zoomer.
view-help-change = <b>Change</b> la raideur, l’amortissement, les longueurs et les angles dans l’onglet « Jouer », ou dessine ton propre objet avec « Modifier ».
view-help-measure = <b>Mesure</b> avec des graphiques où se lisent la période et l’amortissement, avec des flèches, une règle, un rapporteur et un chronomètre.
view-help-time = La barre sous l’objet ramène à n’importe quel instant de la simulation. « Lancer » repart de l’instant affiché ; ce qui s’est passé avant ton retour en arrière reste visible en ligne fine. Clique sur une masse ou touche-la pour lire les valeurs de son articulation.
