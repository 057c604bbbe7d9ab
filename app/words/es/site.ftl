site-title = Cuerdas y cuerpos blandos
site-about = Cada imagen abre un cuerpo que se mueve: arrástralo, dóblalo, cambia sus números. Funciona en el navegador y no se envía nada a ninguna parte.
site-own = Escenas propias
site-find = Buscar una escena
site-count = { $count ->
    [one] { $count } escena
   *[other] { $count } escenas
}
site-found = { $count ->
    [one] { $found } de { $count } escena
   *[other] { $found } de { $count } escenas
}
site-none = Ninguna escena contiene todas estas palabras.
site-unknown = Aquí no hay ninguna escena llamada { $name }.
site-groups = Grupos
site-dark = Página oscura
site-made = Hecho con softrod. Estas páginas no necesitan ni servidor ni red.
site-kept = Todo está ahora en este dispositivo y se abre aquí también sin red.

site-bar = Galería
site-all = Todas las escenas
    .hint = Todas las escenas (O)
site-before = Anterior: { $scene }
site-after = Siguiente: { $scene }
site-save = Guardar esta página en un solo archivo
