# What is measured, in lists and on the axes of plots; formulas and tables have the English names.

# Of what: joint.
quantity-joint = joint
    .counted = joint{ $number }
quantity-joint-angle = angle
quantity-joint-rate = rate
quantity-joint-rest-angle = rest_angle
quantity-joint-torque = torque
quantity-joint-wrapped-angle = wrapped_angle
# Of what: spring.
quantity-spring = spring
    .counted = spring{ $number }
quantity-spring-length = length
quantity-spring-elongation = elongation
quantity-spring-direction = direction
quantity-spring-force = force
quantity-spring-wrapped-direction = wrapped_direction
# Of what: mass.
quantity-mass = mass
    .counted = mass{ $number }
quantity-mass-x = x
quantity-mass-y = y
quantity-mass-vx = vx
quantity-mass-vy = vy
quantity-mass-speed = speed
quantity-mass-ax = ax
quantity-mass-ay = ay
quantity-mass-mass = mass
quantity-mass-momentum-x = momentum_x
quantity-mass-momentum-y = momentum_y
# Of what: body.
quantity-body = body
quantity-body-x = x
quantity-body-y = y
quantity-body-vx = vx
quantity-body-vy = vy
quantity-body-mass = mass
quantity-body-momentum-x = momentum_x
quantity-body-momentum-y = momentum_y
quantity-body-angular-momentum = angular_momentum
quantity-body-angular-momentum-about-origin = angular_momentum_about_origin
# Of what: energy.
quantity-energy = energy
quantity-energy-total = total
quantity-energy-kinetic = kinetic
quantity-energy-gravity = gravity
quantity-energy-linear = linear
quantity-energy-angular = angular
quantity-energy-walls = walls
quantity-energy-fillings = fillings
quantity-energy-contact = contact
quantity-energy-anchors = anchors
quantity-energy-damping = damping
quantity-energy-air = air
quantity-energy-friction = friction
quantity-energy-plastic = plastic
quantity-energy-broken = broken
quantity-energy-law = law
quantity-energy-keys = keys
quantity-energy-muscles = muscles
quantity-energy-motors = motors
quantity-energy-changes = changes
quantity-energy-fallbacks = fallbacks
quantity-energy-residual = residual
# Of what: stability.
quantity-stability = stability
quantity-stability-dt-over-limit = dt_over_limit
# Of a second body, from the first.
quantity-ghost = ghost
quantity-ghost-distance = distance
