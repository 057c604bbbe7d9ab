edit-tools = Modification
edit-bar = Ce qui est sélectionné
edit-waits-build = Touche pour une masse, glisse pour un ressort
edit-waits-joint = Touche une masse, puis un de ses angles
edit-waits-select = Touche un élément, ou entoure-en plusieurs
edit-waits-cut = Glisse à travers des ressorts
edit-paste = Coller
edit-done = Terminé
edit-rests = Repos déplacé
    .hint = Les ressorts et articulations de ce qui est déplacé prennent leurs nouvelles longueurs et leurs nouveaux angles comme repos, ou gardent les anciens
edit-stiffen = La garder, { $times } fois plus raide
edit-undo = Annuler : { $what }
    .none = Rien à annuler
    .done = Annulé : { $what }
edit-redo = Rétablir : { $what }
    .none = Rien à rétablir
edit-masses = { $count ->
    [one] { $count } masse
   *[other] { $count } masses
}
edit-springs = { $count ->
    [one] { $count } ressort
   *[other] { $count } ressorts
}
edit-joints = { $count ->
    [one] { $count } articulation
   *[other] { $count } articulations
}
edit-parts = { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
}
edit-mass = masse { $number }
edit-spring = ressort { $number }
edit-joint = articulation { $number }
edit-selected = Sélection : { $parts }
    .none = Rien n’est sélectionné
edit-open = Outils ouverts : { $tool }
    .closed = Outils fermés
edit-begins = Un ressort commence à la masse { $mass } : Entrée sur une autre les relie et continue de là, Échap termine
    .ended = La chaîne de ressorts est terminée
edit-cross = Croix à { $place }. Les flèches la déplacent, avec Maj d’un dixième ; Entrée appuie à cet endroit, Échap l’enlève
    .gone = La croix est enlevée
edit-cross-on = { $place } : { $part }
edit-rests-at = au repos à { $angle }
edit-moved = Masses déplacées
    .text = Les ressorts et articulations de ce que tu as déplacé peuvent être au repos tels qu’ils sont maintenant, ou garder leurs longueurs à vide et leurs angles au repos : ils tirent alors pour y revenir dès que la simulation est lancée.
    .take = Prendre les nouvelles longueurs
    .keep = Garder les longueurs à vide
    .once = Ceci n’est demandé qu’une fois. Le bouton « Repos déplacé » permet d’en changer.
edit-texts = Nom et description de cette scène
    .name = Nom
    .description = Ce qu’elle montre
    .done = Terminé
    .cancel = Annuler
edit-picture = Image
    .hint = Une image derrière l’objet, pour dessiner par-dessus ; elle reste dans ce navigateur
    .size = Taille
    .opacity = Opacité
    .move = La déplacer
    .drag = Fais-la glisser ou utilise les touches fléchées, jusqu’à Échap
    .another = Une autre
    .remove = L’enlever
edit-no-picture = { $name } n’est pas une image que ce navigateur peut afficher

edit-not-pasted = Cela ne peut pas être collé
edit-not-copied = Cela ne peut pas être copié
edit-sags = L’objet s’affaisse ?
    .text = Réinitialise, puis appuie sur « Garder cette forme » à côté des outils : l’objet restera tel que tu l’as dessiné.

number-mixed = mixte
number-middle = milieu
number-note = { $number } ({ $note })
number-proportions = Garder les proportions
    .hint = un nombre règle alors la plus grande valeur, et les autres changent en proportion
number-holding = Masses
    .pin = Fixer
    .release = Libérer
number-rest = Repos tel quel
    .hint = les longueurs à vide et les angles au repos deviennent ceux de maintenant
number-delete = Supprimer
number-position-x = Départ x
number-position-y = Départ y
number-mass = Masse
number-radius = Rayon
number-force-x = Force x
number-force-y = Force y
number-spring-stiffness = Raideur
number-spring-damping = Amortissement
number-spring-rest-length = Longueur à vide
number-spring-strength = Résistance
number-spring-yield-force = Force à la limite élastique
number-spring-hardening = Écrouissage
number-joint-stiffness = Raideur de l’articulation
number-joint-damping = Amortissement de l’articulation
number-joint-rest-angle = Angle au repos
number-joint-yield-torque = Couple à la limite élastique
number-spring-muscle-amplitude = Amplitude du muscle
number-spring-muscle-phase = Phase du muscle
number-spring-muscle-per-beat = Ondes du muscle par battement
number-joint-muscle-amplitude = Amplitude du muscle d’articulation
number-joint-muscle-phase = Phase du muscle d’articulation
number-joint-muscle-per-beat = Ondes du muscle d’articulation par battement
number-joint-motor-speed = Vitesse du moteur
number-joint-motor-torque = Couple du moteur

way-touch = Les masses touchent
    .hint = les balles se heurtent : elles rebondissent les unes sur les autres et, là où il y a contact, sur les ressorts
    .usual = aucune autre masse
    .solid = les autres balles
way-move = Les masses bougent
    .hint = une masse sur un rail ne bouge que le long de celui-ci, comme un chariot
    .usual = librement
    .level = à gauche et à droite sur un rail
    .upright = en haut et en bas sur un rail
way-springs = Les ressorts agissent
    .hint = une corde ne fait que tirer, et une butée n’agit que d’un côté de son angle au repos
    .usual = dans les deux sens
    .pull = en tirant seulement
    .push = en poussant seulement
way-joints = Les articulations agissent
    .hint = { way-springs.hint }
    .usual = des deux côtés
    .above = au-dessus de leur angle seulement
    .below = au-dessous de leur angle seulement
way-turn = Les articulations tournent
    .hint = un moteur fait tourner le second ressort d’une articulation par rapport au premier
    .usual = librement
    .motor = par un moteur
    .left-right = par un moteur, avec les touches Gauche et Droite
    .up-down = par un moteur, avec les touches Haut et Bas
way-forces = Les forces agissent
    .hint = une force sur une masse agit toujours, ou tant qu’une touche fléchée est maintenue
    .usual = toujours
    .left-right = avec les touches Gauche et Droite
    .up-down = avec les touches Haut et Bas
way-muscles = Les muscles agissent
    .hint = un muscle agit toujours, ou tant qu’une touche fléchée est maintenue ; s’il est constant, il reste alors tel qu’il est
    .usual = en rythme
    .left-right = en rythme, avec les touches Gauche et Droite
    .up-down = en rythme, avec les touches Haut et Bas
    .steady-left-right = de façon constante, avec les touches Gauche et Droite
    .steady-up-down = de façon constante, avec les touches Haut et Bas
way-joint-muscles = Les muscles d’articulation agissent
    .hint = { way-muscles.hint }
    .usual = { way-muscles.usual }
    .left-right = { way-muscles.left-right }
    .up-down = { way-muscles.up-down }
    .steady-left-right = { way-muscles.steady-left-right }
    .steady-up-down = { way-muscles.steady-up-down }

done-masses-removed = { $count ->
    [one] { $count } masse supprimée
   *[other] { $count } masses supprimées
}
done-springs-removed = { $count ->
    [one] { $count } ressort supprimé
   *[other] { $count } ressorts supprimés
}
done-joints-removed = { $count ->
    [one] { $count } articulation supprimée
   *[other] { $count } articulations supprimées
}
done-muscles-removed = { $count ->
    [one] { $count } muscle supprimé
   *[other] { $count } muscles supprimés
}
done-springs-cut = { $count ->
    [one] { $count } ressort coupé
   *[other] { $count } ressorts coupés
}
done-springs-added = { $count ->
    [one] { $count } ressort ajouté
   *[other] { $count } ressorts ajoutés
}
done-joints-added = { $count ->
    [one] { $count } articulation ajoutée
   *[other] { $count } articulations ajoutées
}
done-muscles-added = { $count ->
    [one] { $count } muscle ajouté
   *[other] { $count } muscles ajoutés
}
done-masses-pinned = { $count ->
    [one] { $count } masse fixée
   *[other] { $count } masses fixées
}
done-masses-let-go = { $count ->
    [one] { $count } masse libérée
   *[other] { $count } masses libérées
}
done-masses-moved = { $count ->
    [one] { $count } masse déplacée
   *[other] { $count } masses déplacées
}
done-masses-mirrored = { $count ->
    [one] { $count } masse retournée
   *[other] { $count } masses retournées
}
done-masses-duplicated = { $count ->
    [one] { $count } masse dupliquée
   *[other] { $count } masses dupliquées
}
done-masses-pasted = { $count ->
    [one] { $count } masse collée
   *[other] { $count } masses collées
}
done-muscles-moved = { $count ->
    [one] { $count } muscle déplacé
   *[other] { $count } muscles déplacés
}
done-muscles-changed = { $count ->
    [one] { $count } muscle modifié
   *[other] { $count } muscles modifiés
}
done-muscles-spread = { $count ->
    [one] { $count } muscle réparti
   *[other] { $count } muscles répartis
}
done-springs-critically-damped = { $count ->
    [one] { $count } ressort à l’amortissement critique
   *[other] { $count } ressorts à l’amortissement critique
}
done-triangulated-springs-added = { $count ->
    [one] triangulation : { $count } ressort ajouté
   *[other] triangulation : { $count } ressorts ajoutés
}
done-mass-added = masse ajoutée
done-mass-and-spring-added = masse et ressort ajoutés
done-masses-and-a-spring-added = { $count } masses et un ressort ajoutés
done-nothing-removed = rien de supprimé
done-nothing-mirrored = rien de retourné
done-rest-as-it-is = repos tel quel
done-keep-this-shape = garder cette forme
done-fitted = ajustement
done-scene-renamed = scène renommée
done-scene-described = scène décrite
done-mode = mode { $count }
done-own-values-of-the-body = valeurs propres à l’objet
done-own-values-of-the-solver = valeurs propres au solveur
done-number-set = { $number }, valeur réglée : { $parts }
done-number-scaled = { $number }, mise à l’échelle : { $parts }
done-way = { $way } : { $choice }
done-lesson-deleted = leçon supprimée
done-step-added = étape { $count } ajoutée
done-step-duplicated = étape { $count } dupliquée
done-step-removed = étape { $count } supprimée
done-step-moved = « { $title } » déplacée à l’étape { $count }
done-beginning-of-step = début de l’étape { $count }
done-title-of-step = titre de l’étape { $count }
done-task-of-step = consigne de l’étape { $count }
done-what-to-watch-of-step = ce qu’il faut observer à l’étape { $count }
done-question-of-step = question de l’étape { $count }
done-prediction-of-step = prédiction de l’étape { $count }
done-goal-of-step = objectif de l’étape { $count }
done-what-is-handed-in-of-step = ce qui est rendu à l’étape { $count }
done-sliders-of-step = curseurs de l’étape { $count }
done-plots-of-step = graphiques de l’étape { $count }
done-arrows-of-step = flèches de l’étape { $count }
done-second-body-of-step = second objet de l’étape { $count }
done-run-of-step = simulation de l’étape { $count }

edit-no-corner = il n’y a aucun coin sans ressort angulaire
edit-no-brace = il n’y a plus rien à trianguler
edit-no-selection = rien n’est sélectionné
edit-no-move = rien de ce qui est sélectionné ne peut être déplacé
