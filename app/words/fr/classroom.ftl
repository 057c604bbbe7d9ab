class-title = softrod : une séance
class-needs-javascript = Une séance a besoin de JavaScript, qui est désactivé ici.
class-blocked = La page est chargée, mais sa connexion en direct échoue : quelque chose bloque les WebSockets en chemin. Essaie un autre réseau, comme le partage de connexion de l’ordinateur du professeur.
class-over = La séance est terminée.
class-why = Pourquoi ? Réponse en une phrase.
class-hand-in = C’est le moment de rendre les résultats.
class-goal = Objectif : { $goal }
class-goal-met = Objectif atteint : { $goal }
class-found = Ce que la classe a trouvé
class-qr-code = Code QR de { $address }
class-plot = { $what } selon { $over } : { $count ->
    [one] { $count } point
   *[other] { $count } points
  }
  .law = { $what } selon { $over } : { $count ->
    [one] { $count } point
   *[other] { $count } points
  } ; { $law }
class-plot-you = toi : { $value }
class-grip = Masse { $mass } de ta prédiction : la déplacer avec les touches fléchées
class-grips = Ta prédiction
class-moved-mass = Masse { $mass } : { $moved }
class-moved =
  .lower = { $length } plus bas
  .higher = { $length } plus haut
  .left = { $length } vers la gauche
  .right = { $length } vers la droite
class-where-put = vos prédictions

## La page d’un élève.

seat-region = Classe
seat-nothing-kept = Rien de ce que tu as donné n’est gardé ici.
seat-away-alone = Pas de connexion : ton objet continue ici, mais cela ne compte pas. Reconnexion…
seat-hand-up = Lever la main
seat-hand-is-up = Main levée
seat-on-page = Une autre page de ce navigateur a maintenant ta place.
seat-on-device = Un autre appareil a maintenant ta place.
seat-come-back = Revenir ici
seat-who = Qui es-tu ? Tape ton nom, pour que ton professeur sache de qui viennent ces réponses.
seat-your-name = Ton nom
seat-name-me = C’est moi
seat-on-wall = Ton travail est maintenant au tableau.
seat-follow = Regarder l’objet du professeur
seat-own-body = Revenir à mon objet
seat-about = Cette place
seat-why = La question, et pourquoi
seat-waiting = Pas encore chez le professeur : c’est gardé ici et sera envoyé dès que possible.
seat-letters = Les quatre lettres au tableau
seat-come-in = Entrer

seat-is-in = Tu es dans la séance. Elle commence bientôt.
seat-look = Regarde le tableau.
seat-teacher-away = La page de ton professeur n’est pas connectée en ce moment : attends.
seat-gathered = Regarde le tableau : c’est l’objet de ton professeur. Le tien attend.
seat-follows = C’est l’objet de ton professeur. Le tien attend.
seat-paused = En pause : regarde le tableau.
seat-can-change = Tu peux encore changer. Personne d’autre ne peut le voir pour l’instant.
seat-ask-drag = Place l’objet pâle là où il sera { $seconds } s après le départ. Personne d’autre ne peut le voir pour l’instant.
seat-ask-both = Place l’objet pâle là où il sera { $seconds } s après le départ et choisis une réponse. Personne d’autre ne peut le voir pour l’instant.
seat-ask-choose = Choisis une réponse. Personne d’autre ne peut la voir pour l’instant.
seat-ask-again = Choisis encore une fois. Personne d’autre ne peut voir ta réponse pour l’instant.
seat-try = Essaie : cet objet est à toi.

seat-home-drag = Place l’objet pâle là où il sera { $seconds } s après le départ. Ensuite, la simulation est lancée.
seat-home-both = Place l’objet pâle là où il sera { $seconds } s après le départ et choisis une réponse. Ensuite, la simulation est lancée.
seat-home-choose = Choisis une réponse. Ensuite, la simulation est lancée.
seat-late-now = Ce que tu donnes maintenant compte comme en retard.
seat-home-own = À toi maintenant : cet objet est à toi.
seat-step = Étape { $number }
seat-step-done = Étape { $number }, faite
seat-next-step = Suite : étape { $number } sur { $steps }
seat-to-do = { $count ->
    [one] Encore à faire : étape { $steps }.
   *[other] Encore à faire : étapes { $steps }.
  }
seat-all-done = Toutes les étapes sont faites. Tu peux fermer cette page.
seat-told-on = Tu verras la bonne réponse le { $date }.

seat-watch = Observe :
seat-chose-before = Avant, tu avais choisi : { $choice }
seat-chose = { $late ->
    [yes] Tu as choisi : { $choice } (en retard : après l’annonce des réponses).
   *[no] Tu as choisi : { $choice }.
  }
seat-right = La bonne réponse : { $choice }.

seat-predict = Il sera là
  .place = Rendre : { $place }
seat-predicted = Ta prédiction est rendue
  .place = Ta prédiction est rendue : { $place }
seat-handed-moved = Les réponses sont affichées : ta prédiction a été rendue telle que tu l’avais placée.
seat-step-left = Un peu vers la gauche
seat-step-right = Un peu vers la droite
seat-step-up = Un peu vers le haut
seat-step-down = Un peu vers le bas

seat-because = Parce que
seat-send = Envoyer
seat-change = Changer
seat-sent = Envoyé ✓
seat-pause = Pause
seat-play = Lancer
seat-reset = Réinitialiser
seat-slow = Au quart de la vitesse
seat-reading = { $what } : { $reading }
seat-no-reading = Rien à lire encore : laisse-le bouger un moment.
seat-hand-in = Rendre { $reading }
  .instead = Rendre plutôt { $reading }
seat-hand-in-it = Rendre
  .instead = Rendre plutôt ceci
seat-hand-in-run = Rendre cet essai
  .instead = Rendre plutôt cet essai
seat-handed = { $late ->
    [yes] Rendu (en retard : après l’annonce des réponses).
   *[no] Rendu.
  }
  .text = { $late ->
    [yes] Rendu : { $text } (en retard : après l’annonce des réponses).
   *[no] Rendu : { $text }.
  }

seat-first = Élève 1
seat-second = Élève 2
seat-another-name = Un autre nom
seat-two = Nous sommes deux
seat-move = Continuer sur un autre appareil
seat-move-digits = Sur l’autre appareil, tape { $digits }
seat-had = J’avais une place sur un autre appareil : ses deux chiffres
seat-take-over = La reprendre

## Ce que le professeur dit à la classe à chaque phase, et (.do) ce qu’il fait.

guide-lobby = Ouvrez l’adresse qui est au tableau et tapez les quatre lettres.
  .do = Affichez le tableau avec le vidéoprojecteur. Continuez quand tous sont là.
guide-show = Regardez l’objet : qu’est-ce qui le tient, et qu’est-ce qui le tire ?
  .before = Montrez les éléments. N’appuyez pas encore sur « Lancer » : la simulation vient après la question.
  .do = Montrez les éléments. Appuyez sur « Lancer » pour lâcher l’objet : ce que demande la question vient plus tard.
guide-drag = Tirez l’objet pâle là où il sera { $seconds } s après le départ.
guide-ask = Attendez que tous aient répondu. Ne dites pas ce qui est juste.
guide-again = Essayez de convaincre vos voisins pendant une minute. Puis répondez de nouveau.
  .do = Écoutez. Ne dites pas ce qui est juste.
guide-results = Qui veut bien expliquer son choix ?
  .do = Écoutez deux élèves qui ont répondu différemment. Ne donnez pas encore la bonne réponse.
guide-changed = Qui a changé d’avis, et pourquoi ?
  .do = Ne donnez pas encore la bonne réponse : la simulation la montrera.
guide-run = Observez ce qui se passe.
  .do = Laissez la simulation se dérouler jusqu’à ce que tous aient vu ce qui se passe.
guide-run-new = Observez ce qui se passe. Ceci est nouveau : { $runs }
guide-run-stops = La simulation s’arrête à { $seconds } s. Comparez-la aux prédictions.
guide-reveal = C’est la réponse. Expliquez à vos voisins pourquoi.
  .predicted = Le tableau montre les prédictions à côté de l’objet, puis la bonne réponse. Laissez un moment à la classe avant de parler.
  .do = Le tableau montre la bonne réponse. Laissez un moment à la classe avant de parler.
guide-explain = Marquez deux réponses d’une étoile : elles seront au tableau à la phase suivante. Puis expliquez avec vos propres mots : { $because }
guide-try = Circulez dans la classe. Les mains levées s’affichent à droite.
guide-collect = Rendez votre mesure : { $collects }.
guide-plot = Quand la plupart ont rendu, regardez ensemble le graphique de la classe : que dit-il ? Appuyez sur « Montrer la loi », si ce bouton est proposé.
guide-collected = Quand la plupart ont rendu, mettez-en un au tableau.

## Ce que le serveur dit à une page d’une séance.

class-refuse-together = La classe avance ensemble.
class-refuse-no-home-step = Le devoir n’a pas cette étape.
class-refuse-no-place = La séance n’a pas cet endroit.
class-refuse-sealed = Personne ne voit les réponses avant qu’elles soient toutes montrées.
class-refuse-no-bodies = Les places n’ont pas d’objet à elles en ce moment.
class-refuse-gathered = Tous regardent l’objet du professeur en ce moment.
class-refuse-begun = La séance a commencé : on ne peut plus choisir sa leçon.
class-refuse-steps = Une séance a { $most } étapes au plus ; cette scène en a { $steps }.
class-refuse-closed = La séance a commencé ; demande à ton professeur d’ouvrir la porte.
class-refuse-network = Ton réseau a { $seats } places, le maximum pour un réseau ; ton professeur peut en retirer.
class-refuse-removed = Le professeur a fermé cette place.
class-refuse-full = La classe est complète : elle a { $seats } places.
class-refuse-names = Dans cette classe, les noms sont attribués.
class-refuse-no-name = Un nom doit avoir au moins une lettre.
class-refuse-same-name = Quelqu’un a déjà ce nom.
class-refuse-digits = Aucune place n’a ce numéro en ce moment.
class-refuse-own-answers = Cet appareil a une place avec ses propres réponses.
class-refuse-not-yours = Cette réponse est celle de quelqu’un d’autre.
class-refuse-one = Il n’y a qu’une personne ici.
class-refuse-no-step = La séance n’a pas cette étape.
class-refuse-not-asked = Cela n’a pas été demandé à la classe.
class-refuse-has-run = Tu as vu la simulation : ta première réponse compte.
class-refuse-shown = Les réponses ont été montrées ; la tienne reste comme elle était.
class-refuse-answers = Une place peut donner { $most } réponses.
class-refuse-no-seat = Cette place n’existe pas.
class-refuse-no-answer = Cette réponse n’existe pas.
class-refuse-no-choice = La question n’a pas ce choix.
class-refuse-no-such-place = Cet objet ne peut pas être là.
class-refuse-no-letter = Une phrase doit avoir au moins une lettre.
class-at-goal = objectif atteint
class-not-at-goal = objectif non atteint
class-refuse-tries = Cela faisait trop d’essais ; recharge la page pour continuer.
class-refuse-begin = Cette étape ne peut pas commencer : { $reason }.
class-refuse-other-page = Une autre page a maintenant cette place.
class-refuse-cannot-begin = Cette étape ne peut pas commencer.
class-refuse-no-run = Il n’y a pas d’essai à rendre en ce moment.
class-refuse-replay = Un enregistrement est en cours de lecture ; il n’y a rien à rendre.
class-refuse-code = Il n’y a pas de séance { $code } ici en ce moment.
seat-try-again = Essaie d’autres valeurs et appuie sur « Réinitialiser ».
class-told-at = { $day ->
    [1] 1er
   *[other] { $day }
  } { $month ->
    [1] janvier
    [2] février
    [3] mars
    [4] avril
    [5] mai
    [6] juin
    [7] juillet
    [8] août
    [9] septembre
    [10] octobre
    [11] novembre
   *[12] décembre
  } à { $time }

## Le tableau : ce que tous voient avec le vidéoprojecteur.

class-answered = Réponses : { $done } sur { $all }
class-wrote = Phrases : { $done } sur { $all }
class-handed-in = Rendus : { $done } sur { $all }
wall-nobody = Encore personne ? Certains réseaux isolent les appareils les uns des autres : essayez le partage de connexion de cet ordinateur.
wall-way-in = Ouvrez { $address } et tapez { $code }
wall-scan = Scannez ceci, ou ouvrez { $address } et tapez
wall-here = { $count ->
    [one] { $count } élève est là
   *[other] { $count } élèves sont là
  }
wall-step = Étape { $number } sur { $steps }
wall-now = Maintenant : { $runs }
wall-where = Où sera l’objet { $seconds } s après le départ ?
wall-next = Maintenant : expliquez à vos voisins pourquoi.
wall-trying = { $count ->
    [one] essaie
   *[other] essaient
  }
wall-exploded = { $count ->
    [one] a explosé
   *[other] ont explosé
  }
wall-untouched = { $count ->
    [one] intact
   *[other] intacts
  }
wall-at-goal = { $count ->
    [one] a atteint l’objectif
   *[other] ont atteint l’objectif
  }

## La page du professeur.

desk-lead = Ce qu’il faut dire et faire
desk-room = La classe
desk-over = La séance est terminée
desk-nothing-kept = Rien de ce qui a été donné n’est gardé sur cet ordinateur.

desk-here = { $count } là
desk-wall = Tableau
desk-controls = Réglages
  .label = Réglages de mon objet
desk-not-kept = non enregistré
desk-saving = enregistrement…
desk-pupils-type = Les élèves tapent { $address } et { $code }.
desk-more = Plus
desk-come-in = Comment les élèves entrent

desk-lobby = Faire entrer
desk-show = Présenter
desk-ask = Poser la question
  .again = Reposer la question
desk-results = Montrer les réponses
  .again = Montrer de nouveau les réponses
desk-run = Lancer la simulation
desk-reveal = Révéler la réponse
desk-explain = Faire expliquer en une phrase
desk-try = Laisser essayer
desk-collect = Recueillir
desk-step = Étape { $number }
desk-steps = Étape
desk-phase = Phase { $number } sur { $phases }
desk-minutes = { $minutes } min jusqu’ici
desk-say = Dire
desk-do = Faire
desk-next = Suite : { $place }
desk-last = C’était la dernière étape.
desk-back = Retour
  .label = Retour à : { $place }
desk-all-phases = Toutes les phases

desk-teach = { $part } % de réponses justes : expliquez de nouveau.
  .some = { $part } % de réponses justes parmi les { $votes } données : expliquez de nouveau.
desk-pairs = { $part } % de réponses justes : faites discuter à deux, puis reposez la question.
  .some = { $part } % de réponses justes parmi les { $votes } données : faites discuter à deux, puis reposez la question.
desk-on = { $part } % de réponses justes : continuez.
  .some = { $part } % de réponses justes parmi les { $votes } données : continuez.
desk-replay = Revoir au ralenti
  .now = Au ralenti, depuis le début…
desk-gather = Montrer mon objet à tous
desk-pause = Tout mettre en pause
desk-reset = Tout réinitialiser
desk-give-mine = Donner mon objet à tous
  .confirm = Donner à chacun votre objet tel qu’il est maintenant ? Ce qu’ils ont sera perdu.
desk-law = Montrer la loi
desk-open = Ouvrir la porte
desk-close = Fermer la porte
desk-own-names = Laisser taper les noms
desk-given-names = Attribuer les noms
desk-sheet = Enregistrer une feuille à imprimer
desk-zip = Tout enregistrer dans un zip
desk-end = Terminer
  .confirm = Terminer la séance ? Tout ce qui a été donné sera supprimé.

desk-home-until = Devoir jusqu’au { $date }
  .about = Les élèves entrent quand ils veulent, sans vous. Ils voient les bonnes réponses à cette date, ou dès que vous les annoncez.
desk-home-told = Devoir : réponses annoncées
  .about = Tous voient les bonnes réponses. Ce qui arrive maintenant compte comme en retard.
desk-tell = Annoncer les bonnes réponses maintenant
  .confirm = Annoncer à tous les bonnes réponses maintenant ? Ce qui arrivera ensuite comptera comme en retard.
desk-home-step = { $number }. { $title } : réponses { $answered }, rendus { $handed }

desk-lesson = Leçon
desk-which-lesson = Quelle leçon ?
desk-lesson-steps = { $count ->
    [one] Elle a { $count } étape.
   *[other] Elle a { $count } étapes.
  }
desk-address = Adresse
desk-which-network = Dans quel réseau sont les élèves ?
desk-networks = Cet ordinateur est dans plusieurs réseaux. Les adresses des appareils des élèves commencent de la même façon.
desk-lets-in = Le réseau les laisse-t-il entrer ?
desk-scan = Scannez ceci avec un téléphone qui est dans le réseau des élèves, ou ouvrez { $address }
desk-finds-nothing = Si un téléphone ne trouve rien à cette adresse, le réseau isole les appareils les uns des autres : utilisez le partage de connexion de cet ordinateur.

desk-tried-in-vain = Un appareil : il ne peut pas participer ; il dit pourquoi.
desk-tried = Un appareil : tout va bien, { $ms } ms, { $rate } images par seconde
desk-tried-doubts = Un appareil : fonctionne et dit à quoi faire attention, { $ms } ms, { $rate } images par seconde
desk-projector = Afficher le tableau avec le vidéoprojecteur
desk-open-wall = Ouvrir le tableau
desk-way-in = Le tableau montre aussi ceci, en grand : c’est par là que les élèves entrent.

desk-files = Réponses venues de fichiers
desk-from-files = Des élèves qui ont eu la leçon en fichier : elles comptent comme des réponses en retard, chacune une fois.
desk-lesson-file = Enregistrer la leçon en fichier pour eux
desk-their-files = Leurs fichiers
desk-codes = Ou le texte de leurs codes QR, scanné ou collé
desk-take = Prendre
desk-file-too-long = Ce fichier est trop long pour des réponses à une leçon.
desk-brought = { $name } : { $count ->
    [one] { $count } réponse
   *[other] { $count } réponses
  }.
desk-brought-known = { $name } : { $count ->
    [one] { $count } nouvelle réponse
   *[other] { $count } nouvelles réponses
  } ; déjà reçues : { $known }.
desk-brought-goals = { $count ->
    [one] D’après le fichier lui-même, l’objectif de l’étape { $steps } est atteint.
   *[other] D’après le fichier lui-même, l’objectif des étapes { $steps } est atteint.
  }

desk-count-handed-in = { $count ->
    [one] a rendu
   *[other] ont rendu
  }
desk-count-trying = { $count ->
    [one] essaie
   *[other] essaient
  }
desk-count-exploded = { $count ->
    [one] a explosé
   *[other] ont explosé
  }
desk-count-idle = { $count ->
    [one] n’a rien changé
   *[other] n’ont rien changé
  }

desk-chose = Ce que les élèves ont choisi
  .now = Ce que les élèves ont choisi jusqu’ici
desk-sealed = caché aux élèves
desk-most = { $count ->
    [one] { $count } élève a choisi « { $choice } » : demandez-lui pourquoi.
   *[other] { $count } élèves ont choisi « { $choice } » : demandez à l’un d’eux pourquoi.
  }
desk-predicted = { $count ->
    [one] { $count } élève a donné une prédiction.
   *[other] { $count } élèves ont donné une prédiction.
  }
  .some = { $count ->
    [one] { $count } élève sur { $all } a donné une prédiction.
   *[other] { $count } élèves sur { $all } ont donné une prédiction.
  }
desk-found = Ce que les élèves ont trouvé jusqu’ici

desk-who = Qui est là
desk-who-away = { $here } ; { $away } hors ligne
desk-nobody = Encore personne.
desk-name-two = { $name } (deux)
desk-two = deux
desk-away = hors ligne
desk-follows = regarde votre objet
desk-done = { $done } sur { $steps } étapes
desk-moving = en mouvement
desk-untouched = intact
desk-at-rest = au repos
desk-paused = en pause
desk-exploded = a explosé
desk-goal-reached = objectif atteint
desk-on-wall = au tableau
desk-has-predicted = a donné une prédiction
desk-has-answered = a répondu
desk-hand = main levée
desk-lower-hands = Baisser les mains
desk-to-wall = Mettre au tableau
desk-off-wall = Enlever du tableau
desk-reset-one = Réinitialiser celui-ci
desk-to-all = Retour à tous
desk-move = Passer à un autre appareil
desk-move-digits = Sur l’autre appareil : { $digits }
desk-move-how = Sur l’autre appareil, entrer, choisir « Cette place » et taper { $digits }.
desk-remove = Retirer
  .confirm = Fermer la place de { $name } ? Ce qu’elle a donné sera aussi supprimé.

desk-work = Rendus : { $count }
desk-lines = Phrases : { $count }
desk-predictions = Prédictions : { $count }
desk-gave = Donné : { $what }
desk-by = { $name } : { $what }
desk-a-prediction = une prédiction
desk-a-run = un essai
desk-late = { $what } (en retard)
desk-doubt = { $what } : { $doubt }
desk-star = Montrer cette phrase au tableau, de { $name }
desk-show-body = Montrer au tableau l’objet de { $name }
desk-show-prediction = Montrer au tableau la seule prédiction de { $name }

desk-not-possible = Ce n’est pas possible
desk-cannot-begin = Cette étape ne peut pas commencer
desk-no-zip = Le zip n’a pas pu être créé
desk-no-file = Le fichier de la leçon n’a pas pu être créé
desk-no-sheet = La feuille n’a pas pu être créée
desk-the-run = l’essai
desk-unkept-title = La séance n’est pas enregistrée
desk-unkept = { $reason }. Ce que les élèves donnent maintenant attend sur leurs pages et sera perdu si elles sont fermées. Faites de la place sur le disque de l’ordinateur qui héberge la séance, ou enregistrez le zip maintenant.
desk-kept-title = La séance est de nouveau enregistrée
desk-kept = Tout ce qui a été donné est sur le disque.
desk-goes-on-title = La séance continue
desk-goes-on = Son dossier { $folder } ne peut pas être supprimé : { $reason }.
class-refuse-no-body = Cette place n’a pas d’objet à elle en ce moment.
class-refuse-no-replay = Il n’y a pas de simulation à revoir.
class-refuse-replay-broken = La simulation ne peut pas être revue : { $reason }.
class-refuse-classes = Un serveur héberge { $most } séances au plus.
class-refuse-scenes = Une séance a { $most } étapes au plus ; ces scènes en ont { $steps }.
class-refuse-no-code = Ce n’est pas un code de réponses : il commence par SR1 et a des lettres et des chiffres.
class-refuse-no-file = Ce fichier ne contient pas de réponses à une leçon.
class-refuse-misread = Une lettre du code a été mal lue : scannez-le de nouveau.
class-refuse-other-steps = Ces réponses sont celles d’une leçon avec un autre nombre d’étapes.
class-refuse-empty = Il ne contient encore aucune réponse.
class-refuse-other-lesson = Ces réponses sont celles d’une autre leçon que celle de cette séance.

class-doubt-begins = l’enregistrement commence par ceci : { $what }.
class-doubt-goes-on = l’enregistrement continue par ceci : { $what }.
class-doubt-begins-other = l’enregistrement commence par une autre scène que celle de l’étape.
class-doubt-goes-on-other = l’enregistrement continue par une autre scène que celle de l’étape.
class-doubt-sets = l’enregistrement règle { $what }, pour quoi cette étape n’a pas de curseur.
class-doubt-never = l’enregistrement repart d’où l’objet n’a jamais été ; recommencer et rendre ce nouvel essai.
class-doubt-long = l’enregistrement dure plus de { $what }.

## Le zip que le professeur emporte.

zip-readme = 
    Ce qu’une classe a donné : { $steps ->
        [one] { $steps } étape
       *[other] { $steps } étapes
      }, { $seats ->
        [one] { $seats } place
       *[other] { $seats } places
      }.

    answers.csv      votes, phrases et ce qui a été rendu, une ligne chacun
    found.csv        ce qui a été trouvé et pour quel réglage, une ligne par essai
    predictions.csv  où les masses ont été prédites, dans les unités de la scène, une ligne par masse
    scenes/          ce que la classe a parcouru ; `softrod class scenes/*.json` le parcourt avec une autre classe
    logs/            les essais rendus ; `softrod run --inputs FICHIER` en refait un
    pictures/        comment étaient les objets quand ils ont été rendus

    Les tableaux ont des virgules décimales, et des points-virgules entre les colonnes.

    { $names } Quand la séance est terminée, il n’en reste rien sur l’ordinateur qui l’hébergeait.
zip-typed-names = Certaines places ont des noms tapés par les élèves.
zip-given-names = Les places ont les noms que la séance a attribués.

zip-step = étape
zip-title = titre
zip-asked = tour
zip-seat = place
zip-name = nom
zip-pupil = élève
zip-kind = type
zip-answer = réponse
zip-right = juste
zip-late = en retard
zip-starred = étoile
zip-over = grandeur réglée
zip-over-unit = unité du réglage
zip-setting = valeur réglée
zip-what = grandeur mesurée
zip-unit = unité
zip-found = valeur trouvée
zip-doubt = doute
zip-mass = masse
zip-x = x
zip-y = y

zip-vote = vote
zip-line = phrase
zip-work = rendu
zip-yes = oui
zip-no = non
