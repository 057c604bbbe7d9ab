hud-stopped = detenido
hud-past = mirando atrás
hud-paused = en pausa
hud-rest = en reposo
hud-slow = ralentizado: { $factor } × tiempo real
hud-behind = el cuerpo no puede seguir tan deprisa: la mano va { $distance } por detrás
hud-broken = { $count ->
    [one] { $count } resorte roto
   *[other] { $count } resortes rotos
}
hud-yielded = { $count ->
    [one] { $count } resorte con deformación permanente
   *[other] { $count } resortes con deformación permanente
}
hud-squeezed = comprimido
    .stretched = estirado
hud-step = paso de tiempo { $step } ms, { $percent } % del límite
    .unstable = paso de tiempo { $step } ms, { $percent } % del límite: inestable
    .explodes = paso de tiempo { $step } ms, { $percent } % del límite: inestable, explota al tocarlo

card-sine = seno
card-cosine = coseno
card-angle = ángulo
card-rest-angle = ángulo natural
card-of = de { $count }
card-mass = Masa { $mass }
card-joint = Articulación { $joint }
    .of = Articulación { $joint } (de { $count } aquí)
card-x = x
card-y = y
card-speed = rapidez
card-stiffness = rigidez

rates-factor = factor de tiempo real
rates-steps = pasos por segundo
rates-solver = cálculo, por fotograma
rates-behind = retraso del reloj
rates-rejected = rechazados por segundo
rates-fallbacks = pasos de reserva

errors-title = predictibilidad
    .compiled = aparece cuando esté compilada
    .held = ninguna masa está libre
errors-grow = los errores crecen
    .measured = se mide durante un segundo
errors-factor = los errores crecen, último segundo
errors-rate = tasa
errors-time = tiempo para crecer e veces
    .none = ninguno
errors-solver = su cálculo, por fotograma

tuning-slowest = vibración más lenta
tuning-elastic = la vibración elástica más lenta
tuning-fastest = vibración más rápida
tuning-calm = se calma en
    .after = { $time } (amplitud reducida a la décima parte)
    .never = nunca: sin amortiguamiento
tuning-sag = hundimiento por la gravedad
    .loads = hundimiento por sus cargas
    .value = { $sag }, masa { $mass }
tuning-stable = estable hasta { $step } ms
    .always = estable con cualquier paso
tuning-spring = el resorte { $spring } solo
tuning-spring-fastest = el resorte más rápido solo
tuning-rate = { $frequency } Hz, { $period }, razón de amortiguamiento { $ratio }
    .undamped = { $frequency } Hz, { $period }, sin amortiguamiento
    .none = ninguna
tuning-one-linear-stiffness = 1 % más de rigidez de los resortes
tuning-one-angular-stiffness = 1 % más de rigidez de las articulaciones
tuning-one-gravity = 1 % más de gravedad
tuning-more-sag = { $sag } más de hundimiento
tuning-less-sag = { $sag } menos de hundimiento
tuning-faster = { $percent } % más rápida
tuning-slower = { $percent } % más lenta

ghost-title = fantasma
    .compiled = { $ghost }: aparece cuando esté compilado
    .tolerance = tolerancia / { $finer }
    .step = paso / { $finer }
ghost-distance = distancia ahora
ghost-worst = distancia máxima
ghost-solver = cálculo del fantasma, por fotograma
ghost-error = cualquier error crece
    .factor = × { $factor } en un segundo
ghost-stopped = fantasma detenido
    .why = ha explotado

energy-title = energía
    .compiled = se sigue cuando esté compilada
energy-unit = unidad
energy-kinetic = cinética
energy-gravity = altura
    .loads = altura y cargas
energy-linear = resortes lineales
energy-angular = resortes angulares
energy-walls = profundidad en las paredes
energy-fillings = gases y líquidos
energy-contact = contacto
energy-anchors = trabajo de tu mano
energy-damping = perdida por amortiguamiento
energy-air = perdida en el aire y el medio
energy-friction = perdida en paredes, suelo y contacto
energy-plastic = perdida en deformación permanente
energy-broken = perdida en roturas
energy-law = creada por la ley del tutorial
energy-keys = trabajo de las teclas
energy-muscles = trabajo de los músculos
energy-motors = trabajo de los motores
energy-changes = cambios de ajustes
energy-fallbacks = perdida en pasos de reserva
energy-residual = resto: el error del método

about-edit = Editar nombre y texto
    .new = Poner nombre a esta escena y decir qué muestra
