check-title = softrod : cet appareil peut-il participer ?
check-heading = Un appareil peut-il participer depuis cet endroit ?
check-looking = Vérification en cours : elle prend environ 4 secondes.
check-came = Cette page est arrivée : l’appareil atteint l’ordinateur du professeur.
check-no-script = Son script n’est pas arrivé ou ne fonctionne pas.
  .why = JavaScript est peut-être désactivé, un filtre bloque peut-être les scripts, ou le navigateur est trop ancien. Essaie un autre navigateur, puis un autre réseau : le partage de connexion de l’ordinateur du professeur.

check-good = Tout va bien : une séance fonctionne depuis cet endroit.
check-fair = Une séance fonctionne depuis cet endroit ; lis ce qui est signalé.
check-bad = Une séance ne fonctionne pas ici.
check-again = Réessayer

check-hotspot = Utilise un autre réseau : le partage de connexion de l’ordinateur du professeur ou d’un téléphone n’a pas besoin d’Internet.
check-without = Sans aucune connexion, on peut lire un enregistrement : un seul fichier, que crée la page du professeur sous « Partager ».
check-scripts = Ses scripts arrivent, en { $ms } ms.
check-no-scripts = Les scripts des pages d’une séance n’arrivent pas.
check-blocks = Quelque chose les bloque en chemin.
check-shows = Ce navigateur peut afficher une séance.
check-too-old = Ce navigateur ne peut pas afficher une séance : il est trop ancien.
check-current = Utilise une version récente de Chrome, Edge, Firefox ou Safari.
check-stores = Ce navigateur garde les réponses jusqu’à ce qu’elles soient arrivées.
check-stores-not = Ce navigateur ne garde rien : une réponse qui n’est pas encore arrivée est perdue si la page est rechargée.
check-allow = Quitte la navigation privée ou autorise la page à enregistrer des données.
check-clock = Son horloge est d’accord avec celle du professeur.
check-apart = { $minutes ->
    [one] Son horloge et celle du professeur diffèrent de { $minutes } minute.
   *[other] Son horloge et celle du professeur diffèrent de { $minutes } minutes.
  }
check-https = Cela ne gêne pas une séance, mais les adresses en https peuvent être refusées.
check-no-sockets = Ce navigateur n’établit pas de connexion en direct (WebSocket).
check-connected = Une connexion en direct (WebSocket) s’établit, après { $ms } ms.
check-cut = La connexion a été coupée après { $ms } ms.
check-ends = Quelque chose l’interrompt en chemin.
check-blocked = Aucune connexion en direct (WebSocket) ne s’établit, alors que les pages arrivent : quelque chose en chemin, comme le filtre web ou le proxy de l’école, n’en laisse passer aucune.
check-let-through = Ou demande à la personne qui gère le réseau de laisser passer les WebSockets vers { $host } ; souvent, les pages en https passent là où celles en http ne passent pas.
check-refused = L’ordinateur du professeur refuse la connexion : { $reason }
check-silent = L’ordinateur du professeur ne répond plus.
check-awake = softrod fonctionne-t-il toujours, et l’ordinateur n’est-il pas en veille ?
check-no-answer = La connexion est là, mais aucune réponse n’arrive.
check-holds = Quelque chose retient les messages en chemin.
check-slow = L’aller-retour prend { $ms } ms : les objets suivent le doigt avec du retard.
check-trip = L’aller-retour prend { $ms } ms.
check-nearer = Rapproche-toi de la borne Wi-Fi ou utilise moins d’appareils à la fois.
check-no-pictures = Aucune image animée n’arrive.
check-jerks = Seulement { $rate } images par seconde arrivent : le mouvement est saccadé.
check-pictures = Les images animées arrivent, { $rate } par seconde.
