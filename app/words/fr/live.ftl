live-picture = Ceci est une image : les scripts ne fonctionnent pas ici. Ouvre le fichier dans un navigateur web, et elle s’anime.
live-too-old = Ce navigateur ne peut pas afficher le fichier ; un plus récent le peut.
live-play = Lancer
live-pause = Pause
live-speed = Vitesse

replay-again = Relire
replay-time = Instant affiché
replay-too-old = Ce navigateur ne peut pas lire le fichier ; un plus récent le peut.

live-exploded = L’objet a explosé
live-back = Revenir juste avant
live-side = Réglages et nombres
live-lesson = Leçon
live-others = Plus de curseurs
live-answers = Rendre tes réponses
live-step = +1 pas
live-time = Temps
live-reset = Réinitialiser
live-follow = Suivre
    .hint = Suivre le pointeur
live-view = Affichage et touches

live-arrow-left = Gauche : angles au repos plus petits
    .works = Gauche : { $work }
live-arrow-up = Haut : plus long
    .works = Haut : { $work }
live-arrow-down = Bas : plus court
    .works = Bas : { $work }
live-arrow-right = Droite : angles au repos plus grands
    .works = Droite : { $work }
live-work-motors = faire tourner les moteurs
live-work-muscles = faire agir les muscles
live-work-forces = pousser les masses

live-notes = Dans ce fichier : { $notes }.
live-note-verlet = l’objet est calculé par la méthode de Verlet-vitesse, sans contrôle de l’erreur
live-note-shape = la forme de l’objet ne change pas
live-note-sliders = il n’y a pas de curseur pour : { $settings }
live-note-controls = la leçon n’a pas de réglage pour : { $settings }
live-note-plots = ces graphiques manquent : { $quantities }
live-note-ghost = il n’y a pas de second objet à comparer
live-note-arrows = il n’y a pas de flèches
live-note-goals = certains objectifs ne sont pas évalués
live-note-runs = aucun essai n’est rendu

live-stopped = arrêté
live-paused = en pause
live-slowed = ralenti : { $rate } × le temps réel
live-broken = { $count ->
    [one] { $count } ressort cassé
   *[other] { $count } ressorts cassés
}
live-yielded = { $count ->
    [one] { $count } ressort déformé de façon permanente
   *[other] { $count } ressorts déformés de façon permanente
}
live-limit = pas de temps { $step } ms, { $part } % de la limite
    .over = pas de temps { $step } ms, { $part } % de la limite : instable

live-joint = Articulation { $joint }
    .angle = angle
    .rest = angle au repos
    .sine = sinus
    .cosine = cosinus
live-energy = Énergie, { $unit }
    .kinetic = cinétique
    .height = altitude
    .linear = ressorts
    .angular = ressorts angulaires

live-cause =
    .linear = Le pas de temps de { $step } s dépasse la limite de stabilité de { $limit } s, que fixent les ressorts linéaires.
    .angular = Le pas de temps de { $step } s dépasse la limite de stabilité de { $limit } s, que fixent les ressorts angulaires.
    .small = Le pas de temps est sous la limite de stabilité, mais celle-ci vaut pour de petits mouvements ; l’objet a été déplacé ou réglé trop brutalement.
    .violent = L’objet a été déplacé ou réglé trop brutalement.

live-downwards = { $quantity }, vers le bas
live-over = en fonction de : { $quantity }
live-swing = { $reading }, période { $period } s, amplitude { $amplitude }
live-swings = Périodes { $periods } s ; amplitudes { $amplitudes }
live-at = À { $time } s : { $readings }

live-own-words = Avec tes propres mots :
live-predict = Place les masses là où elles seront après { $time } s. Appuie ensuite sur le bouton.
    .done = Il sera là
    .seen = La ligne fine est ta prédiction pour { $time } s.
live-goal = Objectif : { $goal }.
    .now = Objectif : { $goal }. Maintenant : { $reading }.
    .reached = Objectif atteint : { $goal }.

live-leaves = Rien ne sort de ce fichier tout seul. Donne le fichier à ton professeur ou montre le code QR.
live-name = Ton nom ou ton pseudo, si ton professeur en veut un :
live-save = Enregistrer les réponses dans un fichier
live-qr = Code QR des réponses
    .text = Le code QR est le texte qui est dessous, { $letters } caractères.
    .left = Le code QR est le texte qui est dessous, { $letters } caractères. Il y manque, faute de place : { $left } ; le fichier contient tout.
live-left-prediction = la prédiction de l’étape { $step }
live-left-line = la phrase de l’étape { $step }
    .end = la fin de la phrase de l’étape { $step }

live-dark = Sombre
live-larger = Plus grand, pour un vidéoprojecteur
live-keys-drag = une masse est tenue tant que tu la tires ; plusieurs doigts en tirent plusieurs
    .keys = glisser
live-keys-play = lancer ou mettre en pause
    .keys = Espace
live-keys-step = un pas
live-keys-reset = réinitialiser : l’objet repart du début, avec les curseurs tels qu’ils sont
live-keys-follow = la masse entourée suit le pointeur ou s’arrête
live-keys-longer = les ressorts s’allongent ou raccourcissent
    .keys = ↑ ↓ maintenues
live-keys-bent = les angles au repos augmentent ou diminuent
    .keys = → ← maintenues
live-keys-motors = les moteurs tournent, en avant et en arrière
    .keys = flèches maintenues
live-keys-dark = sombre ou blanc ; plus grand, pour un vidéoprojecteur
live-keys-body = vers l’objet : là, les flèches choisissent une masse, Espace la saisit, les flèches la déplacent
    .keys = Tab
live-keys-help = cette aide

live-sheet-title = { $lesson } : pour le professeur
live-sheet-needs = { $minutes } minutes environ. Il faut un ordinateur avec un vidéoprojecteur, et un téléphone, une tablette ou un ordinateur pour un ou deux élèves. Commencez par { $command } ; { $next } mène d’une phase à la suivante.
live-sheet-next = Suite
live-sheet-how = Poser la question : tous répondent sans voir les autres. Ne pas dire ce qui est juste. Au-dessous de 35 % de réponses justes, expliquer de nouveau ; jusqu’à 70 %, laisser discuter à deux et reposer la question. Lancer la simulation, révéler la réponse, faire écrire à chacun une phrase pour dire pourquoi ; puis ils essaient et rendent.
live-sheet-ask = Poser la question
live-sheet-predict = Faire prédire
    .text = Chacun tire l’objet pâle là où il sera après { $time } s.
live-sheet-run = Lancer
live-sheet-reveal = Révéler
live-sheet-try = Laisser essayer
live-sheet-watch = Observer
live-sheet-goal = Objectif
    .text = { $goal }.
live-sheet-collect = Recueillir
    .text = { $reading }.
