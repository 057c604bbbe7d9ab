site-title = Cordes et objets souples
site-about = Chaque image ouvre un objet qui bouge : tire-le, plie-le, change ses nombres. Il fonctionne dans le navigateur, et rien n’est envoyé nulle part.
site-own = Scènes personnelles
site-find = Trouver une scène
site-count = { $count ->
    [one] { $count } scène
   *[other] { $count } scènes
}
site-found = { $count ->
    [one] { $found } scène sur { $count }
   *[other] { $found } scènes sur { $count }
}
site-none = Aucune scène ne contient tous ces mots.
site-unknown = Il n’y a pas ici de scène appelée { $name }.
site-groups = Groupes
site-dark = Page sombre
site-made = Fait avec softrod. Ces pages n’ont besoin ni de serveur ni de réseau.
site-kept = Tout est maintenant sur cet appareil et s’ouvre ici même sans réseau.

site-bar = Galerie
site-all = Toutes les scènes
    .hint = Toutes les scènes (O)
site-before = Précédente : { $scene }
site-after = Suivante : { $scene }
site-save = Enregistrer cette page en un seul fichier
