ui-templates = Modèle d’angles
ui-mixed = { $setting } (mixte)
    .angles = le curseur tourne le premier angle, et les autres d’autant
    .numbers = le curseur règle le plus grand nombre, et les autres gardent leur rapport avec lui
    .note = <b>mixte</b> : { $what }.
ui-range = de { $low } à { $high }

key-ctrl = Ctrl
key-shift = Maj
key-space = Espace
key-esc = Échap
key-delete = Suppr
key-backspace = Retour arrière
key-tab = Tab
key-or = { $one } ou { $other }
key-too = { $text } ({ $key })
key-of = touche { $keys }
    .held = touche { $keys }, maintenue

ui-panel = Réglages
    .hide = Masquer le panneau
    .show = Afficher le panneau
    .down = Masquer les réglages
    .up = Afficher les réglages
ui-scene = { $title } : choisir une autre scène
ui-close = Fermer
ui-progress = Progression
ui-on = activé
    .off = désactivé
ui-plot-time = temps, s
ui-plot-said = { $label } : maintenant { $now } ; minimum { $low } à { $lowAt } s, maximum { $high } à { $highAt } s.
ui-plot-over = { $label } : maintenant { $now } ; minimum { $low } là où { $across } vaut { $lowAt }, maximum { $high } là où cela vaut { $highAt }.
ui-plot-level = { $label } : { $now } tout le temps.
ui-plot-none = { $label } : pas encore de valeurs.
ui-plot-keys = Les flèches gauche et droite montrent une autre partie du temps, haut et bas une partie plus courte ou plus longue, Début le tout
ui-plot-numbers = Nombres
    .caption = { $count } des nombres visibles, répartis régulièrement ; refermer et rouvrir pour de plus récents

ui-found = Trouvé
    .none = Rien ne s’appelle ainsi. Ce qui appartient à une masse, un ressort ou une articulation se trouve une fois qu’on en a sélectionné un.

ui-number-unclear = { $written } peut vouloir dire { $one } ou { $other }. Écris l’un des deux.
ui-number-none = « { $written } » n’est pas un nombre. Écris-le comme 20000, 2e4 ou 0,05.
ui-number-least = Au moins { $least }.
ui-number-most = Au plus { $most }.
ui-number-sign = Changer le signe

ui-away = Pas de connexion : ton objet attend. Reconnexion…
ui-blocked = La page est chargée, mais sa connexion en direct échoue : quelque chose bloque les WebSockets en chemin. Essaie un autre réseau, comme le partage de connexion de l’ordinateur où fonctionne softrod.
ui-loading = Chargement…
    .later = Sur un réseau lent, la première fois peut prendre jusqu’à une demi-minute.
ui-needs-javascript = softrod a besoin de JavaScript, qui est désactivé ici.
ui-needs-webgl = softrod dessine avec WebGL 2, que ce navigateur n’a pas ou a désactivé : autorise l’accélération matérielle dans ses paramètres ou utilise un autre navigateur.
ui-other-viser = Cette page ne peut pas dessiner : sa page viser n’est pas dans la version que softrod prend en charge.
ui-not-loaded = La page n’est pas arrivée en entier :
ui-no-canvas = Le navigateur ne dessine plus cette page. Ton objet est enregistré :
    .reload = Recharger

ui-pad = Touches fléchées
    .up = Haut
    .left = Gauche
    .down = Bas
    .right = Droite

ui-body = { $count ->
    [one] Objet de { $count } masse
   *[other] Objet de { $count } masses
}
ui-mass = masse { $mass }, { $place }
    .first = masse { $mass }, { $place }. Les flèches choisissent, Espace saisit
    .tools = masse { $mass }, { $place }. Les flèches choisissent, Entrée fait ce que fait l’outil, + ajoute une masse, X déplace une croix
    .held = masse { $mass } saisie. Les flèches la déplacent
    .free = masse { $mass } lâchée
    .none = aucune masse
ui-place = x { $x }, y { $y } { $unit }
ui-opened = { $title } est ouvert
ui-exploded = L’objet a explosé et il est arrêté
ui-running = En mouvement
    .paused = En pause
ui-broken = { $count ->
    [0] Aucun ressort cassé
    [one] { $count } ressort cassé
   *[other] { $count } ressorts cassés
}

ui-too-much = Trop de choses à la fois
    .text = Les dernières demandes ont été ignorées. Réessaie dans un instant.
ui-stopped = Cette page s’est arrêtée
    .text = Une erreur s’est produite sur le serveur. Recharge la page pour continuer.
ui-undo-afresh = L’annulation repart de zéro
    .text = Ce qui a été modifié avant la perte de la connexion ne peut plus être annulé.
ui-commas = Virgules décimales
    .hint = les tableaux enregistrés ont 0,5 au lieu de 0.5, et des points-virgules entre les colonnes

ui-no-preset = il n’y a pas de scène prédéfinie appelée { $name } ; choisis-en une dans la galerie
ui-no-user = la page n’a pas identifié son utilisateur ; recharge-la et réessaie
ui-no-room = tu as ici { $count } scènes, le maximum ; supprimes-en d’abord
    .computer = cet ordinateur n’a plus de place pour les scènes des visiteurs ; télécharge-la en fichier

ui-tab-play = Jouer
ui-tab-measure = Mesurer
ui-tab-solver = Solveur
ui-tab-share = Partager
ui-tab-lesson = Leçon

ui-unsent = Cela ne peut pas être envoyé
    .text = C’est trop gros pour être envoyé par une page : au plus 4,7 Mo, soit environ 11 000 masses.
ui-unsent-resume = Cela ne peut pas être repris
ui-unsent-link = Cela ne peut pas être ouvert
ui-unsent-file = Cela ne peut pas être ouvert
ui-unsent-paste = Cela ne peut pas être collé
ui-unsent-rival = Une course contre cela est impossible
ui-all-controls = Tous les réglages sont affichés
ui-no-scene = Cette adresse n’a pas de scène
